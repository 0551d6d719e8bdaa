#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace bspview {

/// "2 leaves", "1 leaf".
inline std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// "2 scenes", "1 scene".
inline std::string counted(std::uint64_t count, const std::string& one) {
  return counted(count, one, one + "s");
}

}  // namespace bspview
