#include "core/eval/error/pool.h"

#include <algorithm>
#include <numeric>

namespace bspview {
namespace {

constexpr std::array<MetricText, metric_count> metric_texts{{
    {"wrong_hits", "Wrong hits", "lost or phantom per million rays"},
    {"edge_leaks", "Leaks at edges and vertices", "rays that come through, per million aimed"},
    {"acne", "Acne", "self-hits per million leaving rays"},
    {"light_leaks", "Light leaks", "per million hidden shadow rays"},
    {"t_p50", "Error of t, median", "ulp of float"},
    {"t_p999", "Error of t, 99.9 %", "ulp of float"},
    {"t_max", "Error of t, largest", "ulp of float"},
}};

/// What an error of t of exactly 0 is drawn at: far below the rounding of double.
constexpr double least_ulp = 0x1p-40;

std::optional<Estimate> rate(std::uint64_t found, std::uint64_t cases) {
  if (cases == 0) return std::nullopt;
  const double per_million = 1e6 / static_cast<double>(cases);
  if (found == 0) return Estimate{3.0 * per_million, true};
  return Estimate{static_cast<double>(found) * per_million, false};
}

std::optional<Estimate> ulp(const UlpHistogram& errors, double value) {
  if (errors.count() == 0) return std::nullopt;
  return Estimate{std::max(value, least_ulp), value < least_ulp};
}

/// Seconds and rays of one configuration on some scenes, repeat by repeat.
std::vector<double> nanoseconds(const ErrorReport& report, std::span<const std::size_t> scenes,
                                std::size_t config) {
  std::vector<double> ns;
  double rays = 0.0;
  for (const std::size_t index : scenes) {
    const SceneErrors& scene = report.scenes[index];
    for (std::size_t group = 0; group < ray_group_count; ++group) {
      const std::vector<double>& seconds = scene.seconds[config][group];
      if (seconds.empty()) continue;
      ns.resize(seconds.size());
      for (std::size_t i = 0; i < seconds.size(); ++i) ns[i] += 1e9 * seconds[i];
      rays += static_cast<double>(scene.rays[group]);
    }
  }
  for (double& value : ns) value /= rays;
  return ns;
}

bool is_fast_float(const ErrorConfig& config) {
  return config.choice && config.choice->faces != FaceTest::exact &&
         config.choice->faces != FaceTest::moeller_double &&
         config.choice->quadrics == QuadricTest::textbook_float &&
         config.choice->traversal != Traversal::robust;
}

}  // namespace

const MetricText& text_of(Metric metric) {
  return metric_texts[static_cast<std::size_t>(metric)];
}

std::optional<Estimate> estimate(const ErrorCounts& counts, Metric metric) {
  switch (metric) {
    case Metric::wrong_hits:
      return rate(counts.ordinary().wrong(), counts.ordinary().rays);
    case Metric::edge_leaks:
      return rate(counts.aimed().leaks, counts.aimed().rays);
    case Metric::acne:
      return rate(counts.offset.acne, counts.offset.leaving);
    case Metric::light_leaks:
      return rate(counts.offset.leaks, counts.offset.hidden);
    case Metric::t_median:
      return ulp(counts.t_error, counts.t_error.quantile(0.5));
    case Metric::t_tail:
      return ulp(counts.t_error, counts.t_error.quantile(0.999));
    case Metric::t_largest:
      break;
  }
  return ulp(counts.t_error, counts.t_error.largest());
}

bool has_foreign(const ErrorReport& report) {
  return std::ranges::any_of(report.configs, [](const ErrorConfig& one) { return !one.choice; });
}

ErrorPool pool(const ErrorReport& report, std::vector<std::size_t> scenes) {
  ErrorPool pool{std::move(scenes), {}};
  for (std::size_t i = 0; i < report.configs.size(); ++i) {
    PooledConfig one{.config = i};
    const bool everywhere = std::ranges::all_of(
        pool.scenes, [&](std::size_t scene) { return report.scenes[scene].measured[i] != 0; });
    if (!everywhere) continue;
    for (const std::size_t scene : pool.scenes) one.counts += report.scenes[scene].counts[i];
    const std::vector<double> ns = nanoseconds(report, pool.scenes, i);
    one.ns = median_of(ns);
    one.ns_mad = median_absolute_deviation(ns);
    pool.configs.push_back(one);
  }
  std::ranges::stable_sort(pool.configs, {}, &PooledConfig::ns);
  return pool;
}

ErrorPool pool_of_all(const ErrorReport& report) {
  std::vector<std::size_t> all(report.scenes.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return pool(report, std::move(all));
}

ErrorPool pool_of_triangles(const ErrorReport& report) {
  std::vector<std::size_t> scenes;
  for (std::size_t i = 0; i < report.scenes.size(); ++i) {
    if (report.scenes[i].only_triangles) scenes.push_back(i);
  }
  return scenes.empty() ? ErrorPool{} : pool(report, std::move(scenes));
}

TradeOffs trade_offs(const ErrorPool& pool, Metric metric) {
  TradeOffs all;
  for (std::size_t i = 0; i < pool.configs.size(); ++i) {
    const PooledConfig& config = pool.configs[i];
    const std::optional<Estimate> error = estimate(config.counts, metric);
    if (!error) continue;
    all.members.push_back(i);
    // None found is better than one found, whatever its bound says.
    const double ranked = error->is_bound ? error->value / 6.0 : error->value;
    all.points.push_back({config.ns, config.ns_mad, ranked});
    all.errors.push_back(*error);
  }
  return all;
}

Price price_of(std::size_t config, const ErrorReport& report) {
  Price price;
  for (const PooledConfig& other : pool_of_all(report).configs) {
    if (!is_fast_float(report.configs[other.config])) continue;
    price.fastest = other.config;
    break;
  }
  std::array<std::vector<double>, priced_groups.size()> by_group;
  for (const SceneErrors& scene : report.scenes) {
    std::array<double, priced_groups.size()>& ratios = price.ratios.emplace_back();
    for (std::size_t i = 0; i < priced_groups.size(); ++i) {
      const auto group = static_cast<std::size_t>(priced_groups[i]);
      const double fastest = median_of(scene.seconds[price.fastest][group]);
      if (!(fastest > 0.0)) continue;
      ratios[i] = median_of(scene.seconds[config][group]) / fastest;
      by_group[i].push_back(ratios[i]);
    }
  }
  for (std::size_t i = 0; i < by_group.size(); ++i) price.medians[i] = median_of(by_group[i]);
  price.median = median_of(price.medians);
  return price;
}

}  // namespace bspview
