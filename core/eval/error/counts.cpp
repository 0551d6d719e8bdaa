#include "core/eval/error/counts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bspview {

void HitCounts::add(Verdict verdict) {
  ++rays;
  lost += verdict == Verdict::lost;
  phantom += verdict == Verdict::phantom;
  undecided += verdict == Verdict::undecided;
}

HitCounts& HitCounts::operator+=(const HitCounts& other) {
  rays += other.rays;
  lost += other.lost;
  phantom += other.phantom;
  undecided += other.undecided;
  leaks += other.leaks;
  return *this;
}

void UlpHistogram::add(double ulp) {
  largest_ = std::max(largest_, ulp);
  const double octave = ulp > 0.0 ? std::log2(ulp) - least_exponent : -1.0;
  const double bin = std::clamp(octave * bins_an_octave + 1.0, 0.0, static_cast<double>(bins));
  ++counts_[static_cast<std::size_t>(bin)];
}

UlpHistogram& UlpHistogram::operator+=(const UlpHistogram& other) {
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  largest_ = std::max(largest_, other.largest_);
  return *this;
}

std::uint64_t UlpHistogram::count() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

double UlpHistogram::quantile(double share) const {
  const double wanted = share * static_cast<double>(count());
  double below = 0.0;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    below += static_cast<double>(counts_[i]);
    if (below < wanted || below == 0.0) continue;
    if (i == 0) return 0.0;
    const double upper_end = std::exp2(least_exponent + static_cast<double>(i) / bins_an_octave);
    return std::min(upper_end, largest_);
  }
  return largest_;
}

OffsetCounts& OffsetCounts::operator+=(const OffsetCounts& other) {
  leaving += other.leaving;
  acne += other.acne;
  hidden += other.hidden;
  leaks += other.leaks;
  return *this;
}

ErrorCounts& ErrorCounts::operator+=(const ErrorCounts& other) {
  for (std::size_t i = 0; i < hits.size(); ++i) hits[i] += other.hits[i];
  t_error += other.t_error;
  offset += other.offset;
  return *this;
}

HitCounts ErrorCounts::ordinary() const {
  HitCounts sum;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!is_aimed(static_cast<RayGroup>(i))) sum += hits[i];
  }
  return sum;
}

HitCounts ErrorCounts::aimed() const {
  HitCounts sum;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (is_aimed(static_cast<RayGroup>(i))) sum += hits[i];
  }
  return sum;
}

}  // namespace bspview
