#include "core/render/heatmap.h"

#include <algorithm>
#include <array>

#include "core/render/pixel_grid.h"

namespace bspview {
namespace {

/// Depth of every node; index: node.
std::vector<std::uint32_t> node_depths(const Tree& tree) {
  std::vector<std::uint32_t> depths(tree.nodes.size(), 0);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {  // parents come before their children
    const Node node = tree.nodes[i];
    if (!node.is_leaf()) depths[node.left()] = depths[node.right()] = depths[i] + 1;
  }
  return depths;
}

/// Counts what every kind of heat map wants to know of one ray.
class HeatObserver {
 public:
  explicit HeatObserver(std::span<const std::uint32_t> depths) : depths_(depths) {}
  void inner(std::uint32_t, const Node&, StepKind, float, RayInterval) { ++inner_; }
  void leaf(std::uint32_t node, RayInterval) {
    ++leaves_;
    deepest_ = std::max(deepest_, depths_[node]);
  }
  void test(std::uint32_t, bool, double) { ++tests_; }

  std::uint32_t value(Heat heat) const {
    switch (heat) {
      case Heat::nodes:
        return inner_ + leaves_;
      case Heat::tests:
        return tests_;
      case Heat::leaves:
        return leaves_;
      case Heat::depth:
        break;
    }
    return deepest_;
  }

 private:
  std::span<const std::uint32_t> depths_;
  std::uint32_t inner_ = 0, leaves_ = 0, tests_ = 0, deepest_ = 0;
};

constexpr double shown_share = 0.995;  // a few extreme pixels must not darken all others

}  // namespace

std::span<const std::string_view> heat_names() {
  static constexpr std::array<std::string_view, 4> names{"nodes", "tests", "leaves", "depth"};
  return names;
}

std::string_view name_of(Heat heat) {
  return heat_names()[static_cast<std::size_t>(heat)];
}

Result<HeatMap> measure_heat(const World& world, const Camera& camera, const RenderParams& params,
                             Heat heat, std::stop_token stop) {
  const std::vector<std::uint32_t> depths = node_depths(world.tree);
  const PrimaryRays eye(camera, params.width, params.height);
  HeatMap map{params.width, params.height, {}};
  map.values.resize(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  const auto measure_tile = [&](const Tile& tile, int) {
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        const Ray ray = eye.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        HeatObserver observer(depths);
        closest_hit(world, ray, trace_rules(params), observer);
        map.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                   static_cast<std::size_t>(x)] = observer.value(heat);
      }
    }
  };
  with_threads(params.threads, [&] { for_each_tile(map.width, map.height, stop, measure_tile); });
  if (stop.stop_requested()) return Error{"stopped"};
  return map;
}

HeatRange heat_range(const HeatMap& map) {
  if (map.values.empty()) return {};
  std::vector<std::uint32_t> values = map.values;
  const auto [low, largest] = std::ranges::minmax(values);
  const auto rank =
      static_cast<std::ptrdiff_t>(shown_share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return {low, values[static_cast<std::size_t>(rank)], largest};
}

Image color_heat(const HeatMap& map, const HeatRange& range, ColorMap colors) {
  const float width = std::max(1.0f, static_cast<float>(range.high - range.low));
  Image image{map.width, map.height, {}};
  image.pixels.reserve(map.values.size());
  for (const std::uint32_t value : map.values) {
    const std::uint32_t shown = std::clamp(value, range.low, range.high);
    image.pixels.push_back(sample(colors, static_cast<float>(shown - range.low) / width));
  }
  return image;
}

}  // namespace bspview
