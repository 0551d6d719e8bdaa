#include "tests/architecture/float_options.h"

#include <algorithm>
#include <sstream>

namespace bspview::test {
namespace {

constexpr std::string_view loose[] = {"-ffast-math",
                                      "-Ofast",
                                      "-funsafe-math-optimizations",
                                      "-fassociative-math",
                                      "-freciprocal-math",
                                      "-ffinite-math-only",
                                      "-fno-signed-zeros",
                                      "-fcx-limited-range",
                                      "-mfpmath=387"};
constexpr std::string_view contraction = "-ffp-contract=";

}  // namespace

std::vector<std::string> words_of(std::string_view command) {
  std::istringstream stream{std::string(command)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::optional<std::string> find_loose_floats(std::string_view command) {
  std::string last = "nothing";
  for (const std::string& word : words_of(command)) {
    if (std::ranges::find(loose, word) != std::end(loose)) return word;
    if (word.starts_with(contraction)) last = word;
  }
  if (last == "-ffp-contract=off") return std::nullopt;
  return "expected -ffp-contract=off as the last word on contraction, found " + last;
}

}  // namespace bspview::test
