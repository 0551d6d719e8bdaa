#include "core/bsp/cut.h"

#include <algorithm>
#include <new>
#include <utility>

#include "core/base/raw_vector.h"
#include "core/base/timer.h"
#include "core/bsp/cost.h"

namespace bspview {
namespace {

int least_leaf_size(const BuildParams& params) {
  return std::max(1, params.leaf_size);
}

bool same_weights(const BuildParams& a, const BuildParams& b) {
  return a.cost_intersection.has_value() == b.cost_intersection.has_value() &&
         cost_model(a, 0.0f).empty_factor == cost_model(b, 0.0f).empty_factor;
}

/// Whether some leaf lies at the maximal depth: a deeper tree might have more nodes. False soon
/// after a stop is requested.
bool reaches_maximal_depth(const Tree& tree, const std::stop_token& stop) {
  constexpr std::size_t nodes_between_looks = std::size_t{1} << 16;
  RawVector<std::uint8_t> depths;
  depths.resize(tree.nodes.size());
  depths[0] = 0;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (i % nodes_between_looks == 0 && stop.stop_requested()) return false;
    if (depths[i] == tree.max_depth) return true;
    const Node& node = tree.nodes[i];
    if (!node.is_leaf()) depths[node.left()] = depths[node.right()] = depths[i] + 1;
  }
  return false;
}

/// Whether the limits in `params` stop the builder nowhere later than those of `whole`.
bool is_within(const Tree& whole, const BuildParams& params, const std::stop_token& stop) {
  // The whole tree then does not know what testing the objects costs.
  if (whole.params.cost_intersection && !params.cost_intersection) return false;
  if (is_part(params, whole.params, whole.object_count)) return true;
  BuildParams deeper = whole.params;
  deeper.max_depth = depth_cap;
  return is_part(params, deeper, whole.object_count) && !reaches_maximal_depth(whole, stop);
}

/// Grows a tree like Recursion does, with the planes of another one.
class Regrowth {
 public:
  Regrowth(const MaximalTree& whole, Tree& tree, const std::stop_token& stop)
      : whole_(*whole.tree),
        inner_(whole.inner->lists),
        tree_(tree),
        least_saving_(cost_model(tree.params, tree.cost_intersection).least_saving()),
        stop_(stop) {}

  void grow_root() {
    tree_.nodes.resize(whole_.nodes.size());
    tree_.references.resize(whole_.references.size());
    grow(0, 0, 0);
    tree_.nodes.resize(node_count_);
    tree_.references.resize(reference_count_);
  }

 private:
  /// Makes node `from` of the whole tree node `to` of the new one.
  void grow(std::uint32_t from, std::uint32_t to, int depth) {
    if (stop_.stop_requested()) return;
    const Node& node = whole_.nodes[from];
    if (node.is_leaf()) return make_leaf(to, whole_.objects_of(node));
    const std::size_t pair = (node.left() - 1) / 2;
    const std::span<const std::uint32_t> objects = inner_[pair];
    const auto leaf_size = static_cast<std::size_t>(least_leaf_size(tree_.params));
    if (objects.size() <= leaf_size || depth >= tree_.max_depth ||
        inner_.saving(pair) < least_saving_) {
      return make_leaf(to, objects);
    }
    const std::uint32_t left = std::exchange(node_count_, node_count_ + 2);
    tree_.nodes[to] = Node::make_inner(node.axis(), node.split(), left);
    grow(node.left(), left, depth + 1);
    grow(node.right(), left + 1, depth + 1);
  }

  void make_leaf(std::uint32_t to, std::span<const std::uint32_t> objects) {
    const auto count = static_cast<std::uint32_t>(objects.size());
    const std::uint32_t first = std::exchange(reference_count_, reference_count_ + count);
    References& references = tree_.references;
    // Clipping may lose objects between a node and its leaves.
    if (reference_count_ > references.size()) references.resize(2 * std::size_t{reference_count_});
    for (std::uint32_t i = 0; i < count; ++i) references[first + i] = objects[i];
    tree_.nodes[to] = Node::make_leaf(first, count);
  }

  const Tree& whole_;
  const InnerLists& inner_;
  Tree& tree_;
  const double least_saving_;
  const std::stop_token& stop_;
  std::uint32_t node_count_ = 1, reference_count_ = 0;  // written so far
};

std::optional<Tree> regrow(const MaximalTree& whole, const BuildParams& params,
                           const std::stop_token& stop) {
  const Timer timer;
  const Tree& uncut = *whole.tree;
  if (!whole.inner || !is_within(uncut, params, stop)) return {};
  Tree tree{.box = uncut.box,
            .object_count = uncut.object_count,
            .params = params,
            .max_depth = effective_depth(params, uncut.object_count),
            .cost_intersection =
                static_cast<float>(cost_model(params, uncut.cost_intersection).intersection),
            .naive = uncut.naive};
  Regrowth(whole, tree, stop).grow_root();
  if (stop.stop_requested()) return {};
  // A lone root and the naive list are made whatever they take.
  const bool is_limited = tree.max_depth > 0 && !tree.naive;
  if (is_limited && tree.bytes() > params.memory_limit) return {};
  tree.build_seconds = timer.seconds();
  return tree;
}

}  // namespace

Result<MaximalTree> build_maximal_tree(const BuildInput& input, const BuildParams& params,
                                       InnerLimit limit, const Watch& watch) {
  try {
    auto inner = std::make_unique<InnerObjects>(limit);
    Result<Tree> tree = build_tree(input, params, watch, inner.get());
    if (!tree) return tree.error();
    if (!inner->meter.complete()) inner.reset();
    return MaximalTree{std::make_shared<Tree>(*std::move(tree)), std::move(inner)};
  } catch (const std::bad_alloc&) {
    return Error{"not enough memory for the tree"};
  }
}

bool has_costs(Builder builder) {
  return builder != Builder::naive && builder != Builder::median &&
         builder != Builder::median_longest && builder != Builder::object_median;
}

double cost_ratio(const BuildParams& params) {
  return has_costs(params.builder) ? cost_model(params, 1.0f).least_saving() : 0.0;
}

bool same_planes(const BuildParams& a, const BuildParams& b) {
  return a.builder == b.builder && effective_clip(a) == effective_clip(b) &&
         (!has_costs(a.builder) || same_weights(a, b));
}

bool is_part(const BuildParams& part, const BuildParams& whole, std::size_t objects) {
  return same_planes(part, whole) && least_leaf_size(part) >= least_leaf_size(whole) &&
         effective_depth(part, objects) <= effective_depth(whole, objects) &&
         cost_ratio(part) >= cost_ratio(whole);
}

std::optional<Tree> cut(const MaximalTree& whole, const BuildParams& params,
                        const std::stop_token& stop) {
  try {
    return regrow(whole, params, stop);
  } catch (const std::bad_alloc&) {
    return {};
  }
}

}  // namespace bspview
