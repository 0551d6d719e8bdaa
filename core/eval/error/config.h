#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/bsp/tree.h"
#include "core/eval/kernels.h"

namespace bspview {

/// One way to trace rays, as the benchmark of time against error tells them apart.
struct ErrorConfig {
  std::string name;  ///< short: what differs from an anchor; a key in files
  std::string what;  ///< one line for people
  Kernel kernel;
  std::optional<KernelChoice> choice;  ///< nothing: a foreign kernel, for scenes of triangles only
  Builder builder = Builder::sah;
};

/// What is varied.
enum class Factor { faces, traversal, tree, quadrics, offset };
inline constexpr std::size_t factor_count = 5;
std::string_view name_of(Factor factor);

/// One level of every factor, by index.
using Levels = std::array<int, factor_count>;

/// The factors with their levels, and the two anchors.
class ErrorDesign {
 public:
  /// `own` is the default: what the accurate anchor walks and is built with.
  ErrorDesign(Traversal own_traversal, Builder own_builder);

  int level_count(Factor factor) const;
  std::string_view level_name(Factor factor, int level) const;
  Builder builder(int level) const { return builders_[static_cast<std::size_t>(level)]; }
  Levels fast() const { return fast_; }          ///< float textbook throughout
  Levels accurate() const { return accurate_; }  ///< the default

  /// The anchors, then each with one factor changed.
  std::vector<Levels> one_at_a_time() const;
  /// Every combination of the three factors, the others as in the default.
  std::vector<Levels> combinations(std::span<const Factor> factors) const;

  ErrorConfig config(const Levels& levels) const;

 private:
  /// What differs from the nearer anchor.
  std::string short_name(const Levels& levels) const;

  std::vector<Builder> builders_;
  Levels fast_, accurate_;
};

/// The factor in which both differ, when it is just one.
std::optional<Factor> only_difference(const Levels& a, const Levels& b);

/// Adds those levels that are not there yet.
void add_levels(std::vector<Levels>& all, std::span<const Levels> more);

}  // namespace bspview
