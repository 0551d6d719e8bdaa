#include "app/viewer/history.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

TEST(History, UndoesAndRedoesOneStepPerFinishedEdit) {
  History<int> history(1);
  history.commit(2);
  history.commit(5);
  EXPECT_EQ(history.undo(), 2);
  EXPECT_EQ(history.undo(), 1);
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(history.redo(), 2);
  EXPECT_EQ(history.redo(), 5);
  EXPECT_FALSE(history.can_redo());
}

TEST(History, AnUnchangedValueIsNoStep) {
  History<int> history(1);
  history.commit(1);
  EXPECT_FALSE(history.can_undo());
}

TEST(History, AnEditAfterAnUndoForgetsWhatWasUndone) {
  History<int> history(1);
  history.commit(2);
  history.undo();
  history.commit(3);
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.undo(), 1);
}

TEST(History, ThereIsNothingBeforeTheFirstAndAfterTheLastStep) {
  History<int> history(1);
  EXPECT_EQ(history.undo(), 1);
  EXPECT_EQ(history.redo(), 1);
}

}  // namespace
}  // namespace bspview
