#include <fmt/format.h>

#include <algorithm>

#include "core/eval/error/page.h"
#include "core/eval/error/report.h"

namespace bspview {
namespace {

constexpr std::string_view page_style = R"(
body{margin:0 auto;padding:32px 24px 64px;max-width:1180px;color:#1c1c1e;background:#fff;
font:15px/1.5 system-ui,"DejaVu Sans",sans-serif}
h1{font-size:26px;margin:0 0 4px}h2{font-size:19px;margin:44px 0 6px}h3{font-size:16px;margin:36px 0 4px}h4{font-size:14px;margin:22px 0 2px}
p{margin:6px 0;max-width:78ch}.verdict{font-size:16px;margin:10px 0}
.quiet,caption,dt,figcaption{color:#6b6b70}.keys{margin:14px 0}.keys span{margin-right:20px;white-space:nowrap}
.key{display:inline-block;width:10px;height:10px;border-radius:5px;margin-right:6px}
.plots{display:grid;grid-template-columns:repeat(auto-fit,minmax(500px,1fr));gap:26px 34px;margin:18px 0}
figure{margin:0}figcaption{font-size:13px}
.wide{overflow-x:auto}table{border-collapse:collapse;font-size:13px;font-variant-numeric:tabular-nums}
caption{text-align:left;padding-bottom:6px}th{font-weight:600}th,td{padding:3px 9px;text-align:right;
white-space:nowrap;border-bottom:1px solid #ececef}th:first-child,td:first-child{text-align:left;padding-left:0}
tr.own td{font-weight:600}dt{margin-top:8px}dd{margin:0;max-width:78ch}
@media (prefers-color-scheme:dark){body{color:#f2f2f4;background:#161618}th,td{border-color:#2e2e33}
.quiet,caption,dt,figcaption{color:#a0a0a6}}
)";

constexpr std::array all_metrics{Metric::wrong_hits, Metric::acne,   Metric::light_leaks,
                                 Metric::t_median,   Metric::t_tail, Metric::t_largest};
constexpr std::array triangle_metrics{Metric::edge_leaks, Metric::wrong_hits};

std::string scenes_of(const ErrorReport& report, const ErrorPool& pool) {
  std::string names;
  for (const std::size_t scene : pool.scenes) {
    names += (names.empty() ? "" : ", ") + report.scenes[scene].name;
  }
  return escape_markup(names);
}

std::string plots(const ErrorReport& report, const ErrorPool& pool,
                  std::span<const Metric> metrics) {
  std::string html = "<div class=\"plots\">\n";
  for (const Metric metric : metrics) html += trade_off_figure(report, pool, metric);
  return html + "</div>\n";
}

std::string keys(const ErrorReport& report) {
  std::vector<std::pair<const char*, const char*>> kinds{{"float", "Moeller-Trumbore in float"},
                                                         {"woop", "Woop 2013 in float"},
                                                         {"double", "Moeller-Trumbore in double"},
                                                         {"exact", "exact faces"}};
  if (has_foreign(report)) kinds.emplace_back("foreign", "Embree");
  std::string html = "<p class=\"keys\">";
  for (const auto& [kind, name] : kinds) {
    html += fmt::format("<span><i class=\"key {}\"></i>{}</span>", kind, name);
  }
  return html + "</p>\n<p class=\"quiet\">" +
         "Open marks: none found, drawn at the upper bound 3 / N. The ring is what pictures are "
         "traced with, the "
         "dashed line the Pareto front. Point at a mark for its name. " +
         embree_sentence(report) + "</p>\n";
}

std::string section_of_rays(const ErrorReport& report) {
  const ErrorPool all = pool_of_all(report), triangles = pool_of_triangles(report);
  std::string html = "<h2>Rays</h2>\n<p class=\"quiet\">" + scenes_of(report, all) + "</p>\n" +
                     keys(report) + plots(report, all, all_metrics);
  if (!triangles.configs.empty()) {
    html += "<h2>Scenes of triangles only</h2>\n<p class=\"quiet\">" +
            scenes_of(report, triangles) + ": here edges and vertices are aimed at" +
            (has_foreign(report) ? ", and Embree answers, too" : "") + ".</p>\n" +
            plots(report, triangles, triangle_metrics);
  }
  html += "<h2>What the default costs</h2>\n" + price_table_html(report.pictures_config, report) +
          price_table_html(default_config, report);
  html += "<h2>All configurations</h2>\n" + pool_table_html(report, all, all_metrics);
  if (!triangles.configs.empty()) {
    html += "<h3>Scenes of triangles only</h3>\n" +
            pool_table_html(report, triangles, triangle_metrics);
  }
  return html;
}

std::string section_of_images(const ErrorStudy& study) {
  if (study.images.empty()) return "";
  std::string html =
      "<h2>Pictures</h2>\n<p>Error against a converged picture: uniform sampling, adaptive "
      "sampling (--adaptive), and rays left out where they count for little (--cutoff).</p>\n";
  for (const SceneImageError& image : study.images) html += image_section(image);
  return html;
}

std::string method_of_rays(const ErrorReport& report) {
  std::string factors;
  for (const Factor factor : report.strongest_factors) {
    factors += fmt::format("{}{}", factors.empty() ? "" : ", ", name_of(factor));
  }
  return fmt::format(
      R"(<dt>Rays</dt><dd>Recorded once a scene, the same bits for every configuration: those of a picture
(primary, shadow, reflected, refracted), one in a random direction from every primary hit, shuffled
(scattered), and in scenes of triangles rays aimed at random points of edges and at vertices; at most
{} of each. All of them are judged.</dd>
<dt>Wrong hits</dt><dd>Lost (something nearer is surely hit) or phantom (the object is not hit, or not
there), by exact arithmetic on every object near the ray.</dd>
<dt>Leaks at edges and vertices</dt><dd>Of the aimed rays, those that lose the surface they meet and
come through. Rays that only cut a rim, entering by one triangle and leaving by another within a
thousandth of its size, are no leaks.</dd>
<dt>Acne</dt><dd>A ray that leaves a face, or the outside of a sphere or cone, hits it again.</dd>
<dt>Light leaks</dt><dd>A shadow ray finds its light although another object surely hides it, farther
from the surface than 16 ulp of the largest coordinate.</dd>
<dt>Error of t</dt><dd>Of right hits, in ulp of float of the exact t. The kernels of the default keep t
in double.</dd>
<dt>Time</dt><dd>Median of {} repeats over all rays that are not aimed, interleaved A B C A B C over all
configurations, {}; bars show the median absolute deviation (MAD).</dd>
<dt>Pareto front</dt><dd>A configuration is on it when none without a larger error is faster by more than
twice the MAD. Its knee lies farthest below the straight line between its ends, in logarithms; of two
points it is the one whose gain in error exceeds its loss of time.</dd>
<dt>Configurations</dt><dd>One factor at a time from a fast anchor (textbook float, Havran's traversal,
t_min = 1e-4) and from the default; then every combination of the three factors that move time and
errors most: {}.</dd>
)",
      report.params.rays, report.params.repeats, clock_text(report.params.timing_threads), factors);
}

std::string method_of_images() {
  return R"(<dt>Pictures</dt><dd>RMSE is over pixels and channels of the colours as shown, from 0 to 1; relMSE
divides each squared difference by that of the reference plus 0.01 (Rousselle et al. 2011). The converged
picture has uniform samples and every ray. Between measured pictures, curves are straight lines in
logarithms.</dd>
)";
}

std::string section_of_method(const ErrorStudy& study) {
  const Machine& machine = study.rays.machine;
  return "<h2>How it was measured</h2>\n<dl>\n" +
         (study.rays.scenes.empty() ? "" : method_of_rays(study.rays)) +
         (study.images.empty() ? "" : method_of_images()) +
         fmt::format("<dt>Machine</dt><dd>{}, {} cores, {}, {}, bspview {}</dd>\n</dl>\n",
                     escape_markup(machine.cpu), machine.cores, machine.simd, machine.compiler,
                     machine.version);
}

}  // namespace

std::string to_html(const ErrorStudy& study) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<title>bspview: run time against error</title>\n<style>" +
      std::string(page_style) + plot_style() + "</style>\n</head>\n<body>\n" +
      "<h1>Run time against error</h1>\n";
  for (const std::string& sentence : verdict(study)) {
    html += "<p class=\"verdict\">" + escape_markup(sentence) + "</p>\n";
  }
  if (!study.rays.scenes.empty()) html += section_of_rays(study.rays);
  return html + section_of_images(study) + section_of_method(study) + "</body>\n</html>\n";
}

}  // namespace bspview
