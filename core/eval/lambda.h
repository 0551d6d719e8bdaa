#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/watch.h"
#include "core/render/render.h"

namespace bspview {

/// Median of repeated measurements, and their spread: half the distance of the quartiles.
struct Measured {
  double median = 0.0;
  double spread = 0.0;
  int repeats = 0;
  bool operator==(const Measured&) const = default;
};
Measured summarise(std::vector<double> values);

/// The triplet of Havran's paper. Seconds. nullopt: not measured (yet).
struct Lambda {
  std::optional<Measured> t_cb;        ///< T_CB: build of the tree
  std::optional<Measured> t_tr;        ///< T_TR: rendering, shading included, without T_CB
  std::optional<Measured> t_tt_share;  ///< T_TT / T_TR: walking the tree, without object tests
};

struct LambdaParams {
  int build_repeats = 1;  ///< the build that made the tree is the first
  int render_repeats = 1;
  int replay_repeats = 5;  ///< 0: T_TT is not measured
  /// Seconds after which replays are not repeated any more; what was repeated less often says so.
  double patience = std::numeric_limits<double>::infinity();
};

/// T_TR by rendering without counters; T_TT by replay. Every ray of the picture is recorded once
/// with the number of leaves it visits. The recorded rays then walk the tree again, stopping after
/// as many leaves, with the object tests left out: the same nodes in the same order. What reading
/// the rays and the root box test cost is timed by a third run and taken off. Runs are interleaved;
/// T_TT is set against T_TR of the same repeat, so that T_TR is measured at least as often.
/// Fails, with the error "stopped", only when a stop was requested.
Result<Lambda> measure_lambda(const World& world, const Camera& camera, const RenderParams& params,
                              const LambdaParams& repeats, const Watch& watch = {});

/// How many builds and pictures that takes: what the calls of watch.progress add up to.
int planned_runs(const RenderParams& params, const LambdaParams& repeats);

/// The picture whose rays are recorded: `params`, made smaller until it has at most
/// `max_recorded_pixels` eye rays, which bounds the memory for the record. T_TT / T_TR is then that
/// of the smaller picture.
RenderParams recorded_picture(const RenderParams& params);
inline constexpr std::int64_t max_recorded_pixels = std::int64_t{1} << 21;  ///< full HD fits

}  // namespace bspview
