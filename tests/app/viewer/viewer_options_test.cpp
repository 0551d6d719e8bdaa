#include "app/viewer/viewer_options.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

/// The state that a command line leads to.
State state_of(const std::string& arguments) {
  CLI::App app;
  ViewerOptions options;
  add_viewer_options(app, options);
  app.parse(arguments);
  State state;
  apply_options(options, state);
  return state;
}

TEST(ViewerOptions, WithoutAnyTheStateIsTheStandard) {
  EXPECT_EQ(state_of("").picture, PictureSettings());
  EXPECT_EQ(state_of("").build, BuildParams());
}

TEST(ViewerOptions, SamplingIsChosenOnTheCommandLine) {
  const PictureSettings picture = state_of("--spp 64 --adaptive 0.02 --cutoff 0.002").picture;
  EXPECT_EQ(picture.samples, 64);
  EXPECT_EQ(picture.adaptive, 0.02f);
  EXPECT_EQ(picture.cutoff, 0.002f);
}

}  // namespace
}  // namespace bspview
