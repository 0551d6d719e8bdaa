#include "core/base/result.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

TEST(Result, HoldsEitherTheValueOrTheSentence) {
  const Result<int> value = 3;
  const Result<int> error = Error{"no such file"};
  EXPECT_TRUE(value.ok());
  EXPECT_EQ(*value, 3);
  EXPECT_FALSE(error.ok());
  EXPECT_EQ(error.error().message, "no such file");
}

}  // namespace
}  // namespace bspview
