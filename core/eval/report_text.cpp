#include <fmt/format.h>

#include <cmath>

#include "core/base/counted.h"
#include "core/eval/report.h"
#include "core/eval/symbols.h"

namespace bspview {
namespace {

/// Four significant digits, without an exponent where a person can do without.
std::string number(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return "-";
  if (std::abs(*value) >= 1000.0) return fmt::format("{:.0f}", *value);
  return fmt::format("{:.4g}", *value);
}

std::string kinds(const ObjectCounts& count) {
  std::string text;
  const auto add = [&](std::size_t n, std::string_view one, std::string_view many) {
    if (n > 0) text += (text.empty() ? ": " : ", ") + counted(n, one, many);
  };
  add(count.triangles, "triangle", "triangles");
  add(count.polygons, "polygon", "polygons");
  add(count.patches, "patch", "patches");
  add(count.spheres, "sphere", "spheres");
  add(count.cones, "cone", "cones");
  return text;
}

std::string degenerate_text(const ObjectCounts& count) {
  if (count.degenerate == 0) return "";
  return fmt::format(
      "        {} of them can never be hit: no area, length or radius, or a number beyond {:g}\n",
      count.degenerate, max_coordinate);
}

std::string bytes(std::size_t count) {
  if (count < 10240) return fmt::format("{} bytes", count);
  const double kib = static_cast<double>(count) / 1024.0;
  if (kib < 10240.0) return fmt::format("{:.0f} KiB", kib);
  return fmt::format("{:.0f} MiB", kib / 1024.0);
}

std::string tree_text(const TreeReport& tree) {
  const BuildParams& params = tree.params;
  const TreeStats& stats = tree.stats;
  std::string text =
      fmt::format("build   {}, depth at most {}, leaf size {}, clip {}, traversal {}\n",
                  name_of(params.builder), params.max_depth.value_or(0), params.leaf_size,
                  params.clip.value_or(false) ? "on" : "off", name_of(tree.traversal));
  text += fmt::format(
      "tree    {}: {} interior, {}, {} of them empty; {}\n"
      "        deepest leaf at {}, {}, expected cost {}\n",
      counted(stats.nodes, "node"), stats.inner, counted(stats.leaves, "leaf", "leaves"),
      stats.empty_leaves, counted(stats.references, "reference"), stats.deepest_leaf,
      bytes(tree.bytes), number(stats.expected_cost));
  if (params.lazy) {
    text +=
        fmt::format("        lazy: {} of the leaves, with {}, are not built: no ray came there\n",
                    tree.unbuilt_leaves, counted(tree.unbuilt_references, "reference"));
  }
  if (tree.memory_limit_reached) {
    text += fmt::format(
        "        the memory limit of {} was reached: some leaves could have been split\n",
        bytes(params.memory_limit));
  }
  return text;
}

std::string row(const Symbol& symbol, const std::string& value) {
  return fmt::format("  {:<12} {:<46} {:>10}", symbol.symbol, symbol.meaning, value);
}

std::string delta_text(const Delta& delta) {
  std::string text = "\nDelta\n";
  const auto values = values_of(delta);
  for (std::size_t i = 0; i < delta_size; ++i) {
    text += row(delta_symbols()[i], number(values[i])) + "\n";
  }
  return text;
}

/// Indented lines of at most 78 characters.
std::string wrapped(std::string_view text) {
  constexpr std::size_t width = 76;
  std::string lines;
  while (text.size() > width) {
    const std::size_t end = text.rfind(' ', width);
    lines += fmt::format("  {}\n", text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines + fmt::format("  {}\n", text);
}

std::string lambda_text(const Lambda& lambda) {
  std::string text = "\nLambda\n";
  const auto values = values_of(lambda);
  for (std::size_t i = 0; i < lambda_size; ++i) {
    const auto& value = values[i];
    text += row(lambda_symbols()[i], value ? number(value->median) : "-");
    if (value && value->repeats > 1) {
      text += fmt::format(" +- {} ({} runs)", number(value->spread), value->repeats);
    }
    text += "\n";
  }
  if (lambda.t_tt_share) text += wrapped(traversal_time_method());
  return text;
}

std::string rays_text(const RayCounts& rays) {
  const auto line = [](std::string_view kind, std::uint64_t shot, std::uint64_t hit) {
    return fmt::format("  {:<12} {:>14} {:>14}\n", kind, shot, hit);
  };
  return fmt::format("\n{:<14} {:>14} {:>14}\n", "Rays", "shot", "hit something") +
         line("primary", rays.primary, rays.primary_hits) +
         line("secondary", rays.secondary(), rays.secondary_hits) +
         line("shadow", rays.shadow, rays.shadow_hits) +
         line("all", rays.all(), rays.minimal_tests()) +
         fmt::format("  secondary: {} reflected, {} refracted\n", rays.reflected, rays.refracted) +
         fmt::format("  {}, {}, {}\n", counted(rays.tests, "test"),
                     counted(rays.nodes_inner, "interior node"),
                     counted(rays.nodes_leaf, "leaf", "leaves"));
}

}  // namespace

std::string to_text(const Report& report) {
  std::string text = fmt::format("scene   {}, {}{}\n", report.scene_name,
                                 counted(report.objects.objects, "object"), kinds(report.objects));
  text += degenerate_text(report.objects);
  if (report.tree) text += tree_text(*report.tree);
  if (report.first_picture_seconds) {
    text += fmt::format("        first picture {} s after the scene was there\n",
                        number(report.first_picture_seconds));
  }
  if (report.delta) text += delta_text(*report.delta);
  if (report.lambda) text += lambda_text(*report.lambda);
  if (report.rays) text += rays_text(*report.rays);
  if (report.samples_per_pixel) {
    text += fmt::format("  {} {} a pixel\n", number(report.samples_per_pixel),
                        *report.samples_per_pixel == 1.0 ? "sample" : "samples");
  }
  return text;
}

}  // namespace bspview
