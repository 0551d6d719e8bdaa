#include "app/viewer/overlays/leaf_borders.h"

#include <gtest/gtest.h>

#include "core/bsp/stats.h"

namespace bspview {
namespace {

TEST(LeafBorders, LieWhereTheLeafChangesToTheRightOrBelow) {
  const std::vector<std::uint32_t> leaf{1, 1, 2,  //
                                        1, 1, 2,  //
                                        3, 3, no_leaf};
  constexpr std::uint32_t ink = 0xffffffffu;
  const Layer layer = leaf_borders(leaf, 3, 3, ink);
  EXPECT_EQ(layer.pixels, (std::vector<std::uint32_t>{0, ink, 0,      //
                                                      ink, ink, ink,  //
                                                      0, ink, 0}));
}

TEST(LeafBorders, AreWithinOneLeafNowhere) {
  const std::vector<std::uint32_t> leaf(20, 7);
  EXPECT_EQ(leaf_borders(leaf, 5, 4, 0xffffffffu), Layer(5, 4));
  EXPECT_EQ(leaf_borders({}, 0, 0, 0xffffffffu), Layer(0, 0));
}

TEST(LeafBorders, ArePremultiplied) {
  const std::vector<std::uint32_t> leaf{1, 2};
  EXPECT_EQ(leaf_borders(leaf, 2, 1, 0x80ffffffu).pixels[0], 0x80808080u);
}

}  // namespace
}  // namespace bspview
