#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/machine.h"
#include "core/eval/bench/trees.h"
#include "core/render/test_cost.h"

namespace bspview {

struct TuneParams {
  BenchParams bench;  ///< its build: what trials differ from
  std::vector<float> costs{0.02f, 0.03f, 0.04f, 0.06f, 0.1f, 0.2f,
                           0.5f,  1.0f,  2.0f,  4.0f,  8.0f};  ///< C_I of one kind
  std::vector<int> depths{-6, -3, 3, 6};                       ///< more than the automatic depth
  std::vector<int> leaf_sizes{2, 4, 8};
};

/// One tree of a sweep.
struct Trial {
  enum class What { as_given, cost, depth, leaf_size } what = What::as_given;
  TreeRecipe recipe;
  ObjectKind kind = ObjectKind::triangle;  ///< whose cost it tries
};

/// A sweep over trees of one scene.
struct TunedScene {
  std::vector<Trial> trials;  ///< the first is what was given
  TreeComparison trees;       ///< by trial
  Measured best_gain{};  ///< of best_trial, measured anew: the largest of many is so by chance, too
};

struct TuneReport {
  TuneParams params;
  std::vector<TunedScene> scenes;
  Machine machine = this_machine();
};

/// Sends recorded rays through trees with other costs, depths and leaf sizes. watch.progress adds
/// up to 1. Fails as compare_trees does.
Result<TuneReport> run_tune(std::span<const Scene> scenes, const TuneParams& params,
                            const Watch& watch = {});

/// Time through what was given over that through the tree of a trial: above 1 where that is better.
Measured gain(const TunedScene& scene, std::size_t trial);

/// The trial with the largest gain; the first where none is better.
std::size_t best_trial(const TunedScene& scene);

/// The C_I that suits a kind of object: the least that is within 1 % of the best, since higher ones
/// take longer to build; by the geometric mean over the scenes that hold such objects. Nothing
/// where none does.
std::optional<float> fitted_cost(const TuneReport& report, ObjectKind kind);

std::string to_text(const TuneReport& report);
std::string to_json(const TuneReport& report);

}  // namespace bspview
