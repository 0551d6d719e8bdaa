#include "tests/support/builds.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/bsp/stats.h"
#include "core/bsp/validate.h"

namespace bspview::test {

std::vector<BuildParams> every_way(BuildParams params) {
  std::vector<BuildParams> ways;
  for (std::size_t i = 0; i < builder_names().size(); ++i) {
    params.builder = static_cast<Builder>(i);
    for (const bool clip : {false, true}) {
      params.clip = clip;
      ways.push_back(params);
    }
  }
  return ways;
}

std::string describe(const BuildParams& params) {
  return fmt::format("{}, clip {}", name_of(params.builder), effective_clip(params));
}

void expect_valid(const BuildInput& input, const BuildParams& params) {
  const auto tree = build_tree(input, params);
  ASSERT_TRUE(tree.ok()) << tree.error().message;
  const auto valid = validate(*tree, input);
  EXPECT_TRUE(valid.ok()) << valid.error().message;
  EXPECT_LE(tree_stats(*tree).deepest_leaf, depth_cap);
}

void expect_same(const Tree& a, const Tree& b) {
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.references, b.references);
  EXPECT_EQ(a.memory_limit_reached, b.memory_limit_reached);
}

}  // namespace bspview::test
