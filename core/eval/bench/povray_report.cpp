#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/counted.h"
#include "core/eval/bench/povray.h"
#include "core/eval/lambda.h"
#include "core/eval/machine_json.h"

namespace bspview {
namespace {

using Json = nlohmann::ordered_json;

double mean_ratio(const PovrayReport& report) {
  double sum = 0.0;
  for (const PictureTimes& times : report.pictures) sum += std::log(povray_ratio(times));
  return std::exp(sum / static_cast<double>(report.pictures.size()));
}

std::string verdict(const PovrayReport& report) {
  constexpr double wanted = 4.0;
  const double mean = mean_ratio(report);
  return fmt::format(
      "Pictures are made {:.1f} times as fast as by POV-Ray, of {:.0f} aimed at: {}.", mean, wanted,
      mean >= wanted ? "take bspview" : "shading and tracing are due");
}

Json seconds_json(const std::vector<double>& seconds) {
  const Measured all = summarise(seconds);
  return {{"median", all.median}, {"spread", all.spread}};
}

}  // namespace

std::string to_text(const PovrayReport& report) {
  std::string text = fmt::format(
      "pictures of {0} x {0} pixels, one ray a pixel, {1} levels of rays; {2}, "
      "one thread, its processor seconds of tracing\nratio: POV-Ray's better bounding over ours\n\n"
      "{3:<14} {4:>9} {5:>9} {6:>9} {7:>9} {8:>7}\n",
      report.params.side, report.params.max_ray_depth,
      counted(report.params.repeats, "interleaved repeat"), "", "objects", "bspview", "POV boxes",
      "POV BSP", "ratio");
  for (const PictureTimes& times : report.pictures) {
    text += fmt::format("{:<14} {:>9} {:>9.3f} {:>9.3f} {:>9.3f} {:>7.2f}\n", times.name,
                        times.objects, summarise(times.own).median, summarise(times.boxes).median,
                        summarise(times.bsp).median, povray_ratio(times));
  }
  return text + "\n" + verdict(report) + "\n";
}

std::string to_json(const PovrayReport& report) {
  const Machine& machine = report.machine;
  Json json{{"verdict", verdict(report)}, {"mean_ratio", mean_ratio(report)}};
  json["parameters"] = {{"side", report.params.side},
                        {"max_ray_depth", report.params.max_ray_depth},
                        {"repeats", report.params.repeats}};
  for (const PictureTimes& times : report.pictures) {
    json["pictures"].push_back({{"name", times.name},
                                {"objects", times.objects},
                                {"own", seconds_json(times.own)},
                                {"povray_boxes", seconds_json(times.boxes)},
                                {"povray_bsp", seconds_json(times.bsp)},
                                {"ratio", povray_ratio(times)}});
  }
  json["machine"] = machine_json(machine);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_csv(const PovrayReport& report) {
  std::string csv = "scene,objects,own_seconds,povray_boxes_seconds,povray_bsp_seconds,ratio\n";
  for (const PictureTimes& times : report.pictures) {
    csv += fmt::format("\"{}\",{},{:.4f},{:.4f},{:.4f},{:.3f}\n", times.name, times.objects,
                       summarise(times.own).median, summarise(times.boxes).median,
                       summarise(times.bsp).median, povray_ratio(times));
  }
  return csv;
}

}  // namespace bspview
