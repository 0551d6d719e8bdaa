#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bspview::test {

/// Why `file` may not include `included`; nothing when it may. Both as they stand in the source:
/// "core/bsp/tree.h", "imgui.h".
std::optional<std::string> find_broken_rule(std::string_view file, std::string_view included);

/// What a source text includes, in order.
std::vector<std::string> includes_of(std::string_view text);

}  // namespace bspview::test
