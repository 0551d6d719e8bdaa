#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "core/bsp/build.h"
#include "core/bsp/inner_objects.h"

namespace bspview {

/// A tree that others can be cut from. Every builder is greedy: it picks the plane of a node from
/// the node alone, and maximal depth, leaf size and the ratio of C_T to C_I only stop it: the plane
/// with the fewest expected tests is the same for all. So what it builds within tighter limits is
/// the same tree with some inner nodes made leaves. What chooses planes are the empty-space bonus
/// and whether C_I is one for all objects or that of each.
struct MaximalTree {
  std::shared_ptr<Tree> tree;
  std::unique_ptr<const InnerObjects> inner;  ///< null: not kept; nothing can be cut from the tree
};

/// build_tree, and what cutting needs. That is not kept where it passes `limit`, nor where the tree
/// reaches its own memory limit. References of inner nodes take about as many bytes as those of the
/// leaves times the depth.
Result<MaximalTree> build_maximal_tree(const BuildInput& input, const BuildParams& params,
                                       InnerLimit limit, const Watch& watch = {});

/// Whether costs stop the builder; otherwise they change nothing.
bool has_costs(Builder builder);

/// C_T / C_I of such a builder, or C_T where C_I is not given; 0 for the others.
double cost_ratio(const BuildParams& params);

/// Whether build_tree would choose the same planes for both, as far as the limits let it.
bool same_planes(const BuildParams& a, const BuildParams& b);

/// Whether build_tree with `part` makes a part of what it makes of as many objects with `whole`,
/// memory limits aside.
bool is_part(const BuildParams& part, const BuildParams& whole, std::size_t objects);

/// The tree that build_tree would make of the same objects, node for node; nothing where that is
/// not a part of `whole`, larger than params.memory_limit, when memory runs out, and soon after a
/// stop is requested. Its build_seconds are those of the cut. O(size of the result).
std::optional<Tree> cut(const MaximalTree& whole, const BuildParams& params,
                        const std::stop_token& stop = {});

}  // namespace bspview
