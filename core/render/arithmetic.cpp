#include "core/render/arithmetic.h"

#include <array>

namespace bspview {
namespace {

constexpr std::array<std::string_view, 4> arithmetics{"float", "woop", "double", "exact"};
constexpr std::array<std::string_view, 2> offset_rules{"tmin", "bounded"};

}  // namespace

std::span<const std::string_view> arithmetic_names() {
  return arithmetics;
}
std::span<const std::string_view> offset_rule_names() {
  return offset_rules;
}
std::string_view name_of(Arithmetic arithmetic) {
  return arithmetics[static_cast<std::size_t>(arithmetic)];
}
std::string_view name_of(OffsetRule rule) {
  return offset_rules[static_cast<std::size_t>(rule)];
}

}  // namespace bspview
