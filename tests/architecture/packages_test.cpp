#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

#include "core/base/file.h"

namespace bspview {
namespace {

std::string source_text(const std::string& file) {
  const Result<std::string> text = read_file(BSPVIEW_SOURCE_DIR "/" + file);
  EXPECT_TRUE(text.ok());
  return text ? *text : "";
}

std::set<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// The Debian packages that the build asks for: bspview_find(Name package ...) or "package
/// package".
std::set<std::string> packages_of_build() {
  const std::string text = source_text("CMakeLists.txt");
  const std::regex call(R"re(bspview_find(?:_pkg)?\(\w+ (?:"([^"]+)"|([a-z0-9.+-]+)))re");
  std::set<std::string> packages;
  for (std::sregex_iterator match(text.begin(), text.end(), call), end; match != end; ++match)
    packages.merge(words((*match)[1].str() + (*match)[2].str()));
  return packages;
}

std::set<std::string> packages_of_setup() {
  const std::string text = source_text("dev");
  std::smatch list;
  EXPECT_TRUE(std::regex_search(text, list, std::regex(R"(\npackages=\(([^)]+)\))")));
  return words(list[1]);
}

TEST(Packages, SetUpInstallsEveryPackageThatTheBuildAsksFor) {
  const std::set<std::string> installed = packages_of_setup();
  const std::set<std::string> needed = packages_of_build();
  EXPECT_GE(needed.size(), 10u);
  for (const std::string& package : needed) EXPECT_TRUE(installed.contains(package)) << package;
}

}  // namespace
}  // namespace bspview
