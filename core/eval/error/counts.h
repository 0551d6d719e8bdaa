#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/eval/error/rays.h"
#include "core/eval/reference.h"

namespace bspview {

/// Verdicts on the answers to one group of rays. They add up.
struct HitCounts {
  std::uint64_t rays = 0;
  std::uint64_t lost = 0, phantom = 0, undecided = 0;
  std::uint64_t leaks = 0;  ///< of the lost: the ray comes through a surface (see leaks_at)

  void add(Verdict verdict);
  HitCounts& operator+=(const HitCounts& other);
  std::uint64_t wrong() const { return lost + phantom; }
  bool operator==(const HitCounts&) const = default;
};

/// Errors of t in ulp of float, in bins of 1/16 octave: quantiles are right to 5 %, the largest
/// exactly.
class UlpHistogram {
 public:
  void add(double ulp);
  UlpHistogram& operator+=(const UlpHistogram& other);

  std::uint64_t count() const;
  double largest() const { return largest_; }
  /// The error that a share of `share` does not exceed; 0 when those are exact.
  double quantile(double share) const;
  bool operator==(const UlpHistogram&) const = default;

 private:
  static constexpr int bins_an_octave = 16, least_exponent = -40, greatest_exponent = 24;
  static constexpr std::size_t bins = (greatest_exponent - least_exponent) * bins_an_octave;

  std::array<std::uint64_t, bins + 1> counts_{};  // [0]: 0 and less than 2^least_exponent
  double largest_ = 0.0;
};

/// What leaving a surface does wrong.
struct OffsetCounts {
  std::uint64_t leaving = 0;  ///< rays that leave a surface which they cannot meet again
  std::uint64_t acne = 0;     ///< ... and hit it at once
  std::uint64_t hidden = 0;   ///< shadow rays to a light that is surely hidden
  std::uint64_t leaks = 0;    ///< ... and find their way to it

  OffsetCounts& operator+=(const OffsetCounts& other);
  bool operator==(const OffsetCounts&) const = default;
};

/// Everything that was found wrong with one configuration.
struct ErrorCounts {
  std::array<HitCounts, ray_group_count> hits;
  UlpHistogram t_error;  ///< of right closest hits of every group
  OffsetCounts offset;

  ErrorCounts& operator+=(const ErrorCounts& other);
  /// Of rays that are not aimed at edges and vertices; of those that are.
  HitCounts ordinary() const;
  HitCounts aimed() const;
  bool operator==(const ErrorCounts&) const = default;
};

}  // namespace bspview
