#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bspview::test {

/// The words of a compiler's command line.
std::vector<std::string> words_of(std::string_view command);

/// What lets a compiler change the results of floating-point operations in `command`: an option,
/// or a sentence about the missing -ffp-contract=off. Nullopt: nothing does.
std::optional<std::string> find_loose_floats(std::string_view command);

}  // namespace bspview::test
