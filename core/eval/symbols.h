#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/eval/delta.h"
#include "core/eval/lambda.h"

namespace bspview {

/// How one component of Delta or Lambda is shown.
struct Symbol {
  std::string_view key;      ///< in JSON
  std::string_view symbol;   ///< in Havran's paper; "-": it has none there
  std::string_view meaning;  ///< a few words
  std::string_view formula;  ///< with what its letters stand for
};

inline constexpr std::size_t delta_size = 8;
inline constexpr std::size_t lambda_size = 3;

/// In the order of the paper: the septet with the derived N_AOIAL in its place, then the triplet.
const std::array<Symbol, delta_size>& delta_symbols();
const std::array<Symbol, lambda_size>& lambda_symbols();

/// The values in the order of the symbols.
std::array<std::optional<double>, delta_size> values_of(const Delta& delta);
std::array<std::optional<Measured>, lambda_size> values_of(const Lambda& lambda);

/// How T_TT is measured, in one sentence.
std::string_view traversal_time_method();

}  // namespace bspview
