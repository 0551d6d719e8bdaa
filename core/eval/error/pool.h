#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/eval/error/pareto.h"
#include "core/eval/error/run.h"

namespace bspview {

/// What is set against the time.
enum class Metric {
  wrong_hits,   ///< lost and phantom hits of ordinary rays, per million
  edge_leaks,   ///< rays aimed at edges and vertices that come through, per million
  acne,         ///< per million leaving rays
  light_leaks,  ///< per million hidden shadow rays
  t_median,     ///< error of t in ulp of float: the median, that of one in a thousand, the largest
  t_tail,
  t_largest
};
inline constexpr std::size_t metric_count = 7;

struct MetricText {
  std::string_view key;    ///< in files
  std::string_view title;  ///< for people
  std::string_view unit;
};
const MetricText& text_of(Metric metric);

/// A measured error; where nothing was found, the upper bound of that with 95 % certainty, 3 / N.
struct Estimate {
  double value = 0.0;
  bool is_bound = false;
};
/// Nothing for what was not measured at all.
std::optional<Estimate> estimate(const ErrorCounts& counts, Metric metric);

/// Whether Embree is among the configurations: the build found it.
bool has_foreign(const ErrorReport& report);

/// One configuration over the scenes of a pool.
struct PooledConfig {
  std::size_t config = 0;  ///< index into ErrorReport::configs
  ErrorCounts counts;
  double ns = 0.0;      ///< of an average ray: median of the repeats
  double ns_mad = 0.0;  ///< their median absolute deviation
};

/// Configurations that were measured on every one of these scenes, the fastest first.
struct ErrorPool {
  std::vector<std::size_t> scenes;  ///< indices into ErrorReport::scenes
  std::vector<PooledConfig> configs;
};
ErrorPool pool(const ErrorReport& report, std::vector<std::size_t> scenes);
ErrorPool pool_of_all(const ErrorReport& report);
/// Scenes where edges and vertices are aimed at, and foreign kernels answer.
ErrorPool pool_of_triangles(const ErrorReport& report);

/// A pool set against one metric. Elements of `points` are those of `members`, which index
/// ErrorPool::configs. For the fronts, none found counts as half of one; `errors` hold its bound.
struct TradeOffs {
  std::vector<std::size_t> members;
  std::vector<TradeOff> points;
  std::vector<Estimate> errors;
};
TradeOffs trade_offs(const ErrorPool& pool, Metric metric);

/// What a configuration costs: its time over that of our fastest non-robust configuration in float,
/// a group of rays and scene, by medians of the interleaved repeats.
struct Price {
  std::size_t fastest = 0;                    ///< index of that configuration
  std::vector<std::array<double, 3>> ratios;  ///< by scene; 0: no such rays
  std::array<double, 3> medians{};            ///< over scenes
  double median = 0.0;                        ///< of the three
};
inline constexpr std::array<RayGroup, 3> priced_groups{RayGroup::primary, RayGroup::shadow,
                                                       RayGroup::scattered};
Price price_of(std::size_t config, const ErrorReport& report);

}  // namespace bspview
