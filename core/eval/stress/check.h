#pragma once

// What a check of the stress test is. The table is checks.cpp, the checks themselves are the files
// named in rows.h.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/eval/stress/dice.h"
#include "core/eval/stress/subject.h"

namespace bspview::stress {

/// nullopt: it held. Else what was expected and what was found, with the ray in hexadecimal.
using Complaint = std::optional<std::string>;

/// One trial; called from several threads at once unless the check is serial.
using Trial = std::function<Complaint(Dice&)>;

struct Forest;
using SharedForest = std::shared_ptr<const Forest>;

/// What a check is prepared for.
struct Setting {
  const Subject& subject;
  std::shared_ptr<const Scene> scene;  ///< null: scenes of the check's own
  /// The trees of `scene`, grown once for all checks.
  std::function<Result<SharedForest>()> forest;
  std::uint64_t seed = 1;
  std::int64_t last_trial = 0;  ///< largest number of a trial that will be run
};

/// One row of the table.
struct Check {
  std::string_view id;     ///< as "T05"
  std::string_view group;  ///< for --rays
  std::string_view what;   ///< what must hold, one line
  Result<Trial> (*prepare)(const Setting&);
  std::int64_t trials = 0;        ///< of a full run
  std::int64_t scene_trials = 0;  ///< of a full run on a scene the user names; 0: never run on it
  bool serial = false;            ///< trials use every thread themselves
};

/// All of them, by id.
std::span<const Check> checks();

}  // namespace bspview::stress
