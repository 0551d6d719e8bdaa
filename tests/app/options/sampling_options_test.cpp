#include "app/options/sampling_options.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

TEST(SamplingOptions, WhatIsNotAskedForIsNotSet) {
  CLI::App app;
  SamplingOptions options;
  add_sampling_options(app, options, 4);
  app.parse("");
  EXPECT_FALSE(options.samples);
  EXPECT_EQ(options.adaptive, 0.0f);
  EXPECT_EQ(options.cutoff, 0.0f);
}

TEST(SamplingOptions, EveryOptionReachesItsParameter) {
  CLI::App app;
  SamplingOptions options;
  add_sampling_options(app, options, 4);
  app.parse("--spp 64 --adaptive 0.02 --cutoff 0.002");
  EXPECT_EQ(options.samples, 64);
  EXPECT_EQ(options.adaptive, 0.02f);
  EXPECT_EQ(options.cutoff, 0.002f);
}

TEST(SamplingOptions, ValuesThatMeanNothingAreRefused) {
  for (const char* wrong :
       {"--spp 0", "--spp many", "--adaptive -1", "--adaptive nan", "--cutoff 2"}) {
    CLI::App app;
    SamplingOptions options;
    add_sampling_options(app, options, 4);
    EXPECT_THROW(app.parse(wrong), CLI::ParseError) << wrong;
  }
}

}  // namespace
}  // namespace bspview
