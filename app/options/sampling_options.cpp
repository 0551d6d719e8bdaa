#include "app/options/sampling_options.h"

#include "app/options/values.h"

namespace bspview {

void add_sampling_options(CLI::App& app, SamplingOptions& options, int default_samples) {
  app.add_option("--spp", options.samples, "Rays a pixel")
      ->check(CLI::Range(1, 65536).description(""))
      ->type_name("N")
      ->default_str(std::to_string(default_samples));
  app.add_option("--adaptive", options.adaptive,
                 "A pixel with 8 rays gets no more once its error, from 0 to 1, is estimated "
                 "below F; 0: each gets --spp")
      ->check(finite_number(0.0, 1.0))
      ->type_name("F")
      ->capture_default_str();
  app.add_option("--cutoff", options.cutoff,
                 "Rays that change a pixel by a share below F are not shot; 0: all are")
      ->check(finite_number(0.0, 1.0))
      ->type_name("F")
      ->capture_default_str();
}

}  // namespace bspview
