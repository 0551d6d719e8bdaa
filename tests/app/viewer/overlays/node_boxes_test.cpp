#include "app/viewer/overlays/node_boxes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "app/viewer/overlays/line_raster.h"
#include "app/viewer/overlays/rgba.h"
#include "core/base/parallel.h"
#include "tests/support/random_tree.h"

namespace bspview {
namespace {

/// Axis, and the two coordinates of the line beside it.
using Carrier = std::tuple<int, float, float>;
using Interval = std::pair<float, float>;
/// The union of axis-parallel lines: disjoint ascending intervals on each carrier.
using EdgeSet = std::map<Carrier, std::vector<Interval>>;

int axis_of(const Line& line) {
  for (int axis = 0; axis < 3; ++axis) {
    if (line.from[axis] != line.to[axis]) return axis;
  }
  return 0;
}

Carrier carrier_of(const Line& line) {
  const int axis = axis_of(line);
  return {axis, line.from[(axis + 1) % 3], line.from[(axis + 2) % 3]};
}

std::vector<Interval> merged(std::vector<Interval> intervals) {
  std::sort(intervals.begin(), intervals.end());
  std::vector<Interval> result;
  for (const Interval& interval : intervals) {
    if (result.empty() || interval.first > result.back().second) {
      result.push_back(interval);
    } else {
      result.back().second = std::max(result.back().second, interval.second);
    }
  }
  return result;
}

EdgeSet edge_set(const LineList& lines) {
  EdgeSet set;
  for (const Line& line : lines) {
    const int axis = axis_of(line);
    set[carrier_of(line)].push_back(std::minmax(line.from[axis], line.to[axis]));
  }
  for (auto& [carrier, intervals] : set) intervals = merged(intervals);
  return set;
}

/// All leaf boxes, one after the other.
template <class Chosen>
LineList boxes_of_leaves(const Tree& tree, const Chosen& chosen) {
  LineList lines;
  visit_nodes(tree, [&](std::uint32_t node, const Aabb& cell, int depth) {
    if (tree.nodes[node].is_leaf() && chosen(node, depth)) add_box(lines, cell, {});
    return true;
  });
  return lines;
}

NodeBoxStyle plain() {
  NodeBoxStyle style;
  style.color_by = LeafColor::plain;
  return style;
}

/// Grey by objects, 0 to 7: see value_of.
NodeBoxStyle grey() {
  NodeBoxStyle style;
  style.color_by = LeafColor::objects;
  style.scale = {.map = ColorMap::grey, .lo = 0.0f, .hi = 7.0f};
  return style;
}

int value_of(const Line& line, const NodeBoxStyle& style) {
  for (int value = 0; value <= 7; ++value) {
    const float position = position_on(style.scale, static_cast<float>(value));
    if (line.color == pack_color(color_at(style.scale, position))) return value;
  }
  return -1;
}

Camera camera() {
  return frame_box({Vec3(0.0f), Vec3(1.0f)}, {-1.0f, -2.0f, -3.0f}, {0.0f, 1.0f, 0.0f});
}

TEST(NodeBoxes, SplitRectanglesHaveTheSameEdgesAsAllLeafBoxes) {
  for (const int leaves : {1, 2, 3, 10, 500}) {
    const Tree tree = test::make_random_tree(leaves, static_cast<unsigned>(leaves));
    const EdgeSet expected =
        edge_set(boxes_of_leaves(tree, [](std::uint32_t, int) { return true; }));
    const LineList lines = node_box_lines(tree, filter_leaves(tree, {}), plain());
    EXPECT_EQ(lines.size(), 12u + 4u * (leaves - 1));
    EXPECT_EQ(edge_set(lines), expected) << leaves;
    EXPECT_EQ(edge_set(node_box_lines(tree, filter_leaves(tree, {}), grey())), expected) << leaves;
  }
}

TEST(NodeBoxes, FilteredLeavesHaveTheEdgesOfTheirBoxes) {
  const Tree tree = test::make_random_tree(300, 5);
  const auto edges = [&](const LeafFilter& filter) {
    return edge_set(node_box_lines(tree, filter_leaves(tree, filter), plain()));
  };
  const auto count = [&](std::uint32_t node) { return tree.nodes[node].count(); };
  EXPECT_EQ(edges({.contents = LeafFilter::Contents::full}),
            edge_set(boxes_of_leaves(tree, [&](auto node, int) { return count(node) > 0; })));
  EXPECT_EQ(edges({.contents = LeafFilter::Contents::empty}),
            edge_set(boxes_of_leaves(tree, [&](auto node, int) { return count(node) == 0; })));
  EXPECT_EQ(edges({.min_depth = 8, .max_depth = 8}),
            edge_set(boxes_of_leaves(tree, [&](auto, int depth) { return depth == 8; })));
  EXPECT_TRUE(edges({.min_depth = 20}).empty());
}

TEST(NodeBoxes, ChosenLeavesHaveTheEdgesOfTheirBoxes) {
  const Tree tree = test::make_random_tree(300, 6);
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t node = 0; node < tree.nodes.size(); node += 7) chosen.push_back(node);
  const LineList lines =
      node_box_lines(tree, touched_leaves(NodeCells(tree), {}, chosen, {}), plain());
  EXPECT_EQ(edge_set(lines),
            edge_set(boxes_of_leaves(tree, [](auto node, int) { return node % 7 == 0; })));
}

TEST(NodeBoxes, NoPieceOfAnEdgeIsDrawnTwiceInOneSplitRectangle) {
  const Tree tree = test::make_random_tree(200, 9);
  const auto length = [](const LineList& lines) {
    double sum = 0.0;
    for (const Line& line : lines) sum += glm::length(Vec3d(line.to) - Vec3d(line.from));
    return sum;
  };
  const LeafMask shown = filter_leaves(tree, {});
  EXPECT_NEAR(length(node_box_lines(tree, shown, grey())),
              length(node_box_lines(tree, shown, plain())), 1e-5);
}

TEST(NodeBoxes, AnEdgeHasTheGreatestValueOfTheLeavesThatTouchIt) {
  const Tree tree = test::make_random_tree(100, 11);
  const LineList lines = node_box_lines(tree, filter_leaves(tree, {}), grey());
  std::vector<std::pair<Aabb, int>> leaves;
  visit_nodes(tree, [&](std::uint32_t node, const Aabb& cell, int) {
    if (tree.nodes[node].is_leaf()) leaves.push_back({cell, tree.nodes[node].count()});
    return true;
  });
  // No piece has more than the fullest leaf that touches its middle ...
  for (const Line& line : lines) {
    const Vec3 middle = 0.5f * (line.from + line.to);
    int greatest = -1;
    for (const auto& [cell, count] : leaves) {
      if (cell.contains(middle)) greatest = std::max(greatest, count);
    }
    EXPECT_LE(value_of(line, grey()), greatest);
    EXPECT_GE(value_of(line, grey()), 0);
  }
  // ... and every leaf's edge is drawn at least with its own.
  for (const auto& [cell, count] : leaves) {
    LineList box;
    add_box(box, cell, {});
    for (const Line& edge : box) {
      const int axis = axis_of(edge);
      const float middle = 0.5f * (edge.from[axis] + edge.to[axis]);
      int greatest = -1;
      for (const Line& line : lines) {
        if (carrier_of(line) != carrier_of(edge) || line.from[axis] == line.to[axis]) continue;
        if (line.from[axis] > middle || line.to[axis] < middle) continue;
        greatest = std::max(greatest, value_of(line, grey()));
      }
      EXPECT_GE(greatest, count);
    }
  }
}

TEST(NodeBoxes, LinesAreTheSameForAnyNumberOfThreads) {
  const Tree tree = test::make_random_tree(3000, 12);
  const LeafMask shown = filter_leaves(tree, {.contents = LeafFilter::Contents::full});
  std::vector<LineList> results;
  for (const int threads : {1, 2, 5}) {
    with_threads(threads, [&] { results.push_back(node_box_lines(tree, shown, grey())); });
  }
  EXPECT_EQ(results[1], results[0]);
  EXPECT_EQ(results[2], results[0]);
}

TEST(NodeBoxes, PruningWhatIsSmallerThanNothingChangesNoPixel) {
  const Tree tree = test::make_random_tree(2000, 3);
  const LeafMask shown = filter_leaves(tree, {});
  Camera close = camera();
  close.from = close.at + 0.3f * (close.from - close.at);  // part of the tree is beside the picture
  const LineView view{.camera = close, .width = 160, .height = 120, .distance = {}};
  const BoxPruning pruning{{close, 160, 120}, 0.0f};
  const LineList all = node_box_lines(tree, shown, plain());
  const LineList pruned = node_box_lines(tree, shown, plain(), pruning);
  EXPECT_LT(pruned.size(), all.size() - 100);
  EXPECT_EQ(draw_lines(pruned, view), draw_lines(all, view));
}

TEST(NodeBoxes, SmallCellsAreThinnedOut) {
  const Tree tree = test::make_random_tree(5000, 4);
  const LeafMask shown = filter_leaves(tree, {});
  std::size_t before = node_box_lines(tree, shown, grey()).size();
  for (const float min_pixels : {48.0f, 96.0f, 192.0f}) {
    const BoxPruning pruning{{camera(), 640, 640}, min_pixels};
    const std::size_t lines = node_box_lines(tree, shown, grey(), pruning).size();
    EXPECT_LT(lines, before) << min_pixels;
    EXPECT_GE(lines, 12u);
    before = lines;
  }
}

TEST(NodeBoxes, ATreeBesideThePictureHasNoLines) {
  const Tree tree = test::make_random_tree(50, 4);
  Camera away = camera();
  away.at = away.from + (away.from - away.at);
  const BoxPruning pruning{{away, 100, 100}, 1.0f};
  EXPECT_TRUE(node_box_lines(tree, filter_leaves(tree, {}), plain(), pruning).empty());
}

TEST(NodeBoxes, ATreeWithoutExtentOrNodesHasNoLines) {
  EXPECT_TRUE(node_box_lines({}, {}, plain()).empty());
  Tree empty = test::make_random_tree(1, 1);
  empty.box = {};
  EXPECT_TRUE(node_box_lines(empty, filter_leaves(empty, {}), plain()).empty());
}

TEST(NodeBoxes, AStopEndsTheWalk) {
  const Tree tree = test::make_random_tree(1000, 4);
  std::stop_source source;
  source.request_stop();
  const LineList lines =
      node_box_lines(tree, filter_leaves(tree, {}), plain(), {}, source.get_token());
  EXPECT_LE(lines.size(), 12u);
}

TEST(NodeBoxes, TheScaleGoesToTheFullestOrDeepestLeaf) {
  TreeStats stats;
  stats.deepest_leaf = 17;
  stats.leaves_with_count = {3, 2, 0, 1};
  EXPECT_EQ(leaf_color_scale(stats, LeafColor::depth, ColorMap::magma).hi, 17.0f);
  EXPECT_EQ(leaf_color_scale(stats, LeafColor::depth, ColorMap::magma).map, ColorMap::magma);
  EXPECT_EQ(leaf_color_scale(stats, LeafColor::objects, ColorMap::grey).hi, 3.0f);
  EXPECT_EQ(leaf_color_scale({}, LeafColor::objects, ColorMap::grey).hi, 0.0f);
}

}  // namespace
}  // namespace bspview
