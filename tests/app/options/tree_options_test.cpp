#include "app/options/tree_options.h"

#include <gtest/gtest.h>

#include "app/options/command_line.h"

namespace bspview {
namespace {

/// What the options are after `arguments`, or the sentence about what is wrong with them.
struct Parsed {
  TreeOptions options;
  std::string error;
};

Parsed parse(std::vector<std::string> arguments) {
  Parsed parsed;
  CLI::App app;
  add_scene(app, parsed.options.scene)->required();
  add_tree_options(app, parsed.options);
  std::ranges::reverse(arguments);
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    parsed.error = error.what();
  }
  return parsed;
}

TEST(TreeOptions, DefaultsAreThoseOfTheBuilder) {
  const Parsed parsed = parse({"spd:balls"});
  EXPECT_EQ(parsed.error, "");
  EXPECT_EQ(parsed.options.scene, "spd:balls");
  EXPECT_EQ(parsed.options.build, BuildParams{});
  EXPECT_EQ(parsed.options.traversal, Traversal::robust);
}

TEST(TreeOptions, EveryOptionReachesItsParameter) {
  const Parsed parsed =
      parse({"s.nff", "--builder",     "mb",  "--max-depth",      "16",     "--leaf-size",
             "2",     "--clip",        "off", "--cost-traversal", "15",     "--cost-intersection",
             "20",    "--empty-bonus", ".1",  "--traversal",      "havran", "--lazy",
             "off",   "--threads",     "3",   "--memory-limit",   "64M",    "--seed",
             "9"});
  EXPECT_EQ(parsed.error, "");
  BuildParams expected;
  expected.builder = Builder::mb;
  expected.max_depth = 16;
  expected.leaf_size = 2;
  expected.clip = false;
  expected.cost_traversal = 15.0f;
  expected.cost_intersection = 20.0f;
  expected.empty_bonus = 0.1f;
  expected.threads = 3;
  expected.memory_limit = std::size_t{64} << 20;
  EXPECT_EQ(parsed.options.build, expected);
  EXPECT_EQ(parsed.options.traversal, Traversal::havran);
  EXPECT_EQ(parsed.options.seed, 9u);
}

TEST(TreeOptions, EveryBuilderAndTraversalIsKnownByItsName) {
  for (const std::string_view name : builder_names()) {
    EXPECT_EQ(name_of(parse({"s", "--builder", std::string(name)}).options.build.builder), name);
  }
  for (const std::string_view name : traversal_names()) {
    EXPECT_EQ(name_of(parse({"s", "--traversal", std::string(name)}).options.traversal), name);
  }
}

TEST(TreeOptions, AnAbsurdDepthIsTheLargestOne) {
  EXPECT_EQ(parse({"s", "--max-depth", "99999999999999999999999"}).options.build.max_depth,
            std::numeric_limits<int>::max());
  EXPECT_EQ(parse({"s", "--max-depth", "auto"}).options.build.max_depth, std::nullopt);
  EXPECT_EQ(parse({"s", "--max-depth", "0"}).options.build.max_depth, 0);
}

TEST(TreeOptions, LazyTreesGoWithWhatCanGrowAlone) {
  EXPECT_FALSE(parse({"s"}).options.build.lazy);
  EXPECT_TRUE(parse({"s", "--lazy", "on"}).options.build.lazy);
  EXPECT_FALSE(parse({"s", "--lazy", "off"}).options.build.lazy);
  EXPECT_NO_THROW(check_lazy(parse({"s", "--lazy", "on"}).options));
  EXPECT_NO_THROW(check_lazy(parse({"s", "--traversal", "havran"}).options));
  EXPECT_THROW(check_lazy(parse({"s", "--lazy", "on", "--traversal", "havran"}).options),
               CLI::ValidationError);
  EXPECT_THROW(check_lazy(parse({"s", "--lazy", "on", "--builder", "naive"}).options),
               CLI::ValidationError);
}

TEST(TreeOptions, WhatCannotBeLazySaysWhy) {
  CLI::App app;
  TreeOptions options;
  add_tree_options(app, options, "there are no rays");
  EXPECT_NO_THROW(app.parse("--lazy off"));
  try {
    app.parse("--lazy on");
    FAIL();
  } catch (const CLI::ParseError& error) {
    EXPECT_STREQ(error.what(), "--lazy: there are no rays");
  }
}

TEST(TreeOptions, WrongValuesAreRefusedByTheNameOfTheOption) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"--builder", "best"},       {"--max-depth", "-1"},      {"--max-depth", "deep"},
      {"--max-depth", "1.5"},      {"--leaf-size", "0"},       {"--leaf-size", "two"},
      {"--clip", "yes"},           {"--cost-traversal", "-1"}, {"--cost-intersection", "0"},
      {"--cost-traversal", "nan"}, {"--empty-bonus", "1.5"},   {"--traversal", "fast"},
      {"--lazy", "maybe"},         {"--threads", "-1"},        {"--threads", "many"},
      {"--memory-limit", "0"},     {"--memory-limit", "lots"}, {"--seed", "x"}};
  for (const auto& [option, value] : wrong) {
    const std::string error = parse({"s", option + "=" + value}).error;
    EXPECT_NE(error.find(option), std::string::npos) << option << " " << value << ": " << error;
  }
}

TEST(CommandLine, HelpEndsWithZeroAndWrongUsageWithTwo) {
  CLI::App app("test", "test");
  char program[] = "test", help[] = "--help", unknown[] = "--unknown";
  char* asks[] = {program, help};
  char* errs[] = {program, unknown};
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(parse_command_line(app, 2, asks), 0);
  EXPECT_NE(::testing::internal::GetCapturedStdout(), "");
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(parse_command_line(app, 2, errs), 2);
  EXPECT_EQ(
      ::testing::internal::GetCapturedStderr(),
      "test: The following argument was not expected: --unknown (--help lists the options)\n");
  EXPECT_EQ(parse_command_line(app, 1, asks), std::nullopt);
}

}  // namespace
}  // namespace bspview
