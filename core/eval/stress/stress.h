#pragma once

// The stress test: nothing in default settings may ever be wrong. Random trials, each of which can
// be run again by its number; a count of 0 failures in N bounds the rate by 3 / N (95 %).

#include <optional>
#include <string>
#include <vector>

#include "core/base/watch.h"
#include "core/eval/stress/check.h"

namespace bspview::stress {

/// What is run.
struct Plan {
  std::uint64_t seed = 1;
  /// Of each check of `ids`; without ids, of the checks that have a million in a full run, and of
  /// the others in proportion, at least one. nullopt: a full run.
  std::optional<std::int64_t> trials;
  std::optional<std::int64_t> only;  ///< this trial alone
  std::vector<std::string> groups;   ///< empty: all
  std::vector<std::string> ids;      ///< empty: all
  int threads = 0;                   ///< 0: every core
};

/// A trial that did not hold.
struct Failure {
  std::int64_t trial = 0;
  std::string sentence;
};

/// What became of one check on one scene.
struct Row {
  std::string id, group, what;
  std::string scene;  ///< as the user named it; empty: scenes of the check's own
  std::int64_t trials = 0, failures = 0;
  std::optional<Failure> first;  ///< with the lowest number
  double seconds = 0.0;

  /// Of the failures per trial, with 95 % confidence when there was none.
  double upper_bound() const;
};

/// A scene the user named.
struct NamedScene {
  std::string name;
  std::shared_ptr<const Scene> scene;
};

/// How many trials run(...) will make: for the progress.
std::int64_t planned_trials(const Plan& plan, const NamedScene& scene);

/// Runs the checks of `plan`: on `scene` where one is given (those that depend on a scene), else on
/// scenes of their own. watch.progress is told trials. Fails when a tree cannot be built, and with
/// the error "stopped".
Result<std::vector<Row>> run(const Plan& plan, const NamedScene& scene, const Subject& subject,
                             const Watch& watch = {});

/// The command that runs a row's first failure again; the row has one.
std::string command_of(const Row& row, std::uint64_t seed);

/// A line for each row, then the first failure of each with its command.
std::string to_text(std::span<const Row> rows, std::uint64_t seed);
std::string to_json(std::span<const Row> rows, std::uint64_t seed);

}  // namespace bspview::stress
