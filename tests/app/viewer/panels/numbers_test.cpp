#include "app/viewer/panels/numbers.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

TEST(Numbers, ThousandsAreSetApart) {
  EXPECT_EQ(with_thousands(0), "0");
  EXPECT_EQ(with_thousands(999), "999");
  EXPECT_EQ(with_thousands(1402297), "1\u00a0402\u00a0297");
}

TEST(Numbers, SignificantDigitsAreCountedFromTheFirstOneThatIsNotZero) {
  EXPECT_EQ(significant(0.0, 3), "0");
  EXPECT_EQ(significant(12.345, 3), "12.3");
  EXPECT_EQ(significant(0.0041234, 3), "0.00412");
  EXPECT_EQ(significant(12345.6, 3), "12346");
  EXPECT_EQ(significant(-0.5, 2), "-0.50");
}

TEST(Numbers, DurationsChooseTheirUnit) {
  EXPECT_EQ(duration(12.3e-6), "12.3 µs");
  EXPECT_EQ(duration(0.0431), "43.1 ms");
  EXPECT_EQ(duration(1.2399), "1.24 s");
  EXPECT_EQ(duration(200.2), "3 min 20 s");
}

TEST(Numbers, MemoryChoosesItsUnit) {
  EXPECT_EQ(memory(0), "0 B");
  EXPECT_EQ(memory(999), "999 B");
  EXPECT_EQ(memory(1536), "1.50 KiB");
  EXPECT_EQ(memory(3.4 * 1024 * 1024), "3.40 MiB");
}

TEST(Numbers, AChangeIsASignedPercentageAndAFactorFromTwoUpwards) {
  EXPECT_EQ(change(10, 10), "=");
  EXPECT_EQ(change(100, 112), "+12 %");
  EXPECT_EQ(change(100, 96.9), "−3.1 %");
  EXPECT_EQ(change(100, 420), "×4.20");
  EXPECT_EQ(change(100, 100.001), "≈");
  EXPECT_EQ(change(0, 5), "↑");
  EXPECT_EQ(change(5, 0), "↓");
}

TEST(Numbers, OneIsSingular) {
  EXPECT_EQ(counted(1, "leaf", "leaves"), "1 leaf");
  EXPECT_EQ(counted(0, "leaf", "leaves"), "0 leaves");
}

}  // namespace
}  // namespace bspview
