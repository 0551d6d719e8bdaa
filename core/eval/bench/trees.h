#pragma once

#include "core/eval/bench/measure.h"
#include "core/eval/lambda.h"

namespace bspview {

/// A tree and what it makes rays do.
struct TreeFacts {
  double build_seconds = 0.0;
  std::size_t bytes = 0;
  int max_depth = 0;               ///< in force
  float cost_intersection = 0.0f;  ///< in force
  double expected_cost = 0.0;      ///< SAH, in the units of its costs
  double nodes_a_ray = 0.0;        ///< N_AT of all rays, whatever their kind
  double tests_a_hit = 0.0;        ///< N_RPRT; 0 where nothing is hit
};

/// How a tree is built.
struct TreeRecipe {
  BuildParams build;
  TestCosts test_costs = default_test_costs;
  bool operator==(const TreeRecipe&) const = default;
};

/// Trees of one scene, built differently.
struct TreeComparison {
  SceneTimes times;  ///< its peers are the trees
  std::vector<TreeFacts> trees;
};

/// Records rays once and sends them through all trees in turns, as pictures do: eye and shadow rays
/// together, others alone (measure_scene). The first tree is the one that others are held against;
/// its parameters are not needed in `params`. Fails as measure_scene does, and where the hits of
/// two trees differ.
Result<TreeComparison> compare_trees(const Scene& scene, std::span<const TreeRecipe> recipes,
                                     const BenchParams& params, const Watch& watch = {});

/// Time through one tree over that through another: by repeat the geometric mean over the kinds of
/// rays.
Measured time_ratio(const SceneTimes& times, std::size_t tree, std::size_t base);

}  // namespace bspview
