#include <fmt/format.h>

#include "core/eval/error/report.h"

namespace bspview {
namespace {

std::string quoted(std::string_view text) {
  return fmt::format("\"{}\"", text);
}

std::string factor_columns(const ErrorConfig& config) {
  if (!config.choice) return ",,,,";
  const KernelChoice& choice = *config.choice;
  return fmt::format("{},{},{},{},{}", name_of(choice.faces), name_of(choice.quadrics),
                     name_of(choice.traversal), name_of(config.builder), name_of(choice.offset));
}

void add_pool(std::string& csv, std::string_view name, const ErrorReport& report,
              const ErrorPool& pool) {
  for (const PooledConfig& one : pool.configs) {
    const ErrorConfig& config = report.configs[one.config];
    const HitCounts ordinary = one.counts.ordinary(), aimed = one.counts.aimed();
    const OffsetCounts& offset = one.counts.offset;
    csv += fmt::format("{},{},{},{:.3f},{:.3f}", quoted(name), quoted(config.name),
                       factor_columns(config), one.ns, one.ns_mad);
    csv += fmt::format(",{},{},{},{}", ordinary.rays, ordinary.lost, ordinary.phantom,
                       ordinary.undecided);
    csv += fmt::format(",{},{},{},{},{}", aimed.rays, aimed.lost, aimed.phantom, aimed.undecided,
                       aimed.leaks);
    csv += fmt::format(",{},{},{},{}", offset.leaving, offset.acne, offset.hidden, offset.leaks);
    const UlpHistogram& t = one.counts.t_error;
    csv += fmt::format(",{:.6g},{:.6g},{:.6g}\n", t.quantile(0.5), t.quantile(0.999), t.largest());
  }
}

}  // namespace

std::string to_csv(const ErrorReport& report) {
  std::string csv =
      "scenes,configuration,faces,quadrics,traversal,tree,offset,ns_per_ray,ns_per_ray_mad,"
      "rays,lost,phantom,undecided,aimed_rays,aimed_lost,aimed_phantom,aimed_undecided,leaks,"
      "leaving_rays,acne,hidden_shadow_rays,light_leaks,t_ulp_p50,t_ulp_p999,t_ulp_max\n";
  add_pool(csv, "all", report, pool_of_all(report));
  add_pool(csv, "triangles", report, pool_of_triangles(report));
  for (std::size_t i = 0; i < report.scenes.size(); ++i) {
    add_pool(csv, report.scenes[i].name, report, pool(report, {i}));
  }
  return csv;
}

std::string to_csv(std::span<const SceneImageError> images) {
  std::string csv =
      "scene,width,height,reference_samples,method,samples,threshold,cutoff,samples_per_pixel,"
      "seconds,seconds_spread,repeats,rmse,rel_mse,bias_signed,bias_absolute,bias_rms\n";
  for (const SceneImageError& image : images) {
    for (const ImageErrorCurve& curve : image.curves) {
      for (const ImageErrorPoint& point : curve.points) {
        csv += fmt::format("{},{},{},{},{}", quoted(image.scene), image.params.render.width,
                           image.params.render.height, image.params.reference_samples,
                           quoted(curve.name));
        csv += fmt::format(",{},{},{},{:.3f}", point.params.samples, point.params.adaptive,
                           point.params.cutoff, point.samples_per_pixel);
        csv += fmt::format(",{:.6f},{:.6f},{},{:.6g},{:.6g}", point.seconds.median,
                           point.seconds.spread, point.seconds.repeats, point.rmse, point.rel_mse);
        csv += fmt::format(",{:.4g},{:.4g},{:.4g}\n", point.bias.signed_mean,
                           point.bias.absolute_mean, point.bias.root_mean_square);
      }
    }
  }
  return csv;
}

}  // namespace bspview
