#include "core/bsp/memory_limit.h"

#include "core/bsp/tree.h"

namespace bspview {
namespace {

std::size_t leaf_bytes(std::size_t objects) {
  return sizeof(Node) + objects * sizeof(std::uint32_t);
}

}  // namespace

bool has_room(std::size_t memory, std::size_t left_objects, std::size_t right_objects) {
  return sizeof(Node) + leaf_bytes(left_objects) + leaf_bytes(right_objects) <= memory;
}

ChildMemory share_memory(std::size_t memory, std::size_t left_objects, std::size_t right_objects) {
  const std::size_t left = leaf_bytes(left_objects);
  const std::size_t right = leaf_bytes(right_objects);
  const std::size_t spare = memory - sizeof(Node) - left - right;
  const double all = static_cast<double>(left_objects) + static_cast<double>(right_objects);
  const double share = all > 0.0 ? static_cast<double>(left_objects) / all : 0.5;
  const auto spare_left = static_cast<std::size_t>(static_cast<double>(spare) * share);
  return {left + spare_left, right + (spare - spare_left)};
}

}  // namespace bspview
