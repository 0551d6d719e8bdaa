#include <fmt/format.h>

#include "core/eval/bench/report.h"
#include "core/eval/bench/summary.h"

namespace bspview {
namespace {

void add_scene(std::string& csv, const BenchReport& report, const SceneTimes& scene) {
  for (const KindTimes& kind : scene.kinds) {
    for (std::size_t i = 0; i < report.peers.size(); ++i) {
      const PeerTimes& times = kind.peers[i];
      if (times.nanoseconds.empty()) continue;
      const Measured ns = summarise(times.nanoseconds);
      const Measured ratio = speed_ratio(kind, i, baseline(report));
      csv += fmt::format("\"{}\",{},{},{},{},\"{}\"", scene.name,
                         scene.segments > 0 ? "triangles" : "shapes", scene.segments,
                         scene.objects.objects, name_of(kind.kind), report.peers[i].name);
      csv += fmt::format(",{},{:.3f},{:.3f},{:.4f},{:.4f}", times.rays, ns.median, ns.spread,
                         ratio.median, ratio.spread);
      csv += fmt::format(",{},{},{}\n", times.lost, times.phantom, times.elsewhere);
    }
  }
}

}  // namespace

std::string to_csv(const BenchReport& report) {
  std::string csv =
      "scene,shapes,segments,objects,kind,peer,rays,ns_per_ray,ns_per_ray_spread,ratio,"
      "ratio_spread,lost,phantom,elsewhere\n";
  for (const SceneTimes& scene : report.triangles) add_scene(csv, report, scene);
  for (const SceneTimes& scene : report.shapes) add_scene(csv, report, scene);
  return csv;
}

}  // namespace bspview
