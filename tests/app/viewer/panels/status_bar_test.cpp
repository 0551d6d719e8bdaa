#include "app/viewer/panels/status_bar.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

TEST(StatusBar, SaysHowFarATreeIsInWholePercentThatAreReached) {
  Results results;
  EXPECT_EQ(work_text(results), "");
  results.tree_busy = true;
  EXPECT_EQ(work_text(results), "building tree, 0 %");
  results.tree_progress = 0.4399;
  EXPECT_EQ(work_text(results), "building tree, 43 %");
  results.tree_progress = 1.0 - 1e-12;
  EXPECT_EQ(work_text(results), "building tree, 100 %");
}

TEST(StatusBar, ASceneIsLoadedBeforeItsTreeIsBuilt) {
  Results results;
  results.scene_busy = results.tree_busy = results.measures_busy = true;
  EXPECT_EQ(work_text(results), "loading");
  results.scene_busy = results.tree_busy = false;
  EXPECT_EQ(work_text(results), "measuring");
}

}  // namespace
}  // namespace bspview
