#include "app/viewer/overlays/fault_marks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bspview {
namespace {

PixelFaults one_fault(PixelFault fault, int x, int y) {
  PixelFaults faults{.width = 5, .height = 5, .pixels = std::vector(25, PixelFault::none)};
  faults.pixels[static_cast<std::size_t>(5 * y + x)] = fault;
  return faults;
}

TEST(FaultMarks, EveryKindHasAFormOfItsOwn) {
  const auto marked = [](PixelFault fault) {
    const Layer layer = fault_marks(one_fault(fault, 2, 2));
    return std::ranges::count(layer.pixels, fault_color(fault));
  };
  EXPECT_EQ(marked(PixelFault::lost), 5);      // +
  EXPECT_EQ(marked(PixelFault::phantom), 5);   // x
  EXPECT_EQ(marked(PixelFault::self_hit), 9);  // square
  const Layer cross = fault_marks(one_fault(PixelFault::phantom, 2, 2));
  EXPECT_EQ(cross.pixels[5 * 2 + 1], 0u);
  EXPECT_EQ(cross.pixels[5 * 1 + 1], fault_color(PixelFault::phantom));
}

TEST(FaultMarks, NothingIsDrawnWhereNothingIsWrongOrBeyondTheBorder) {
  for (const PixelFault fault : {PixelFault::none, PixelFault::unchecked})
    EXPECT_EQ(fault_marks(one_fault(fault, 2, 2)), Layer(5, 5));
  const Layer corner = fault_marks(one_fault(PixelFault::self_hit, 0, 4));
  EXPECT_EQ(std::ranges::count(corner.pixels, fault_color(PixelFault::self_hit)), 4);
}

}  // namespace
}  // namespace bspview
