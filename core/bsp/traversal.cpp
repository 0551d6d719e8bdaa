#include "core/bsp/traversal.h"

#include <array>

namespace bspview {
namespace {

constexpr std::array<std::string_view, 3> names{"sung-shirley", "havran", "robust"};

}  // namespace

std::span<const std::string_view> traversal_names() {
  return names;
}
std::string_view name_of(Traversal traversal) {
  return names[static_cast<std::size_t>(traversal)];
}

}  // namespace bspview
