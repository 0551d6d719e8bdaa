#pragma once

#include <span>
#include <string_view>

namespace bspview {

/// How a ray walks the tree. Sources at the traverse_<name>.h files.
enum class Traversal { sung_shirley, havran, robust };

/// Names as on the command line, in the order of the enumerators.
std::span<const std::string_view> traversal_names();
std::string_view name_of(Traversal traversal);

}  // namespace bspview
