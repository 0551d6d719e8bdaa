#pragma once

#include <cstdint>

namespace bspview {

struct GridPlace {
  int x, y;
};

/// The i-th place in Z order (Morton): i < 2^16. The first 4^n fill a square, the first 2 * 4^n a
/// rectangle twice as wide: however many neighbours are traced together, they lie close together.
constexpr GridPlace z_order(std::uint32_t i) {
  const auto even_bits = [](std::uint32_t bits) {
    bits &= 0x5555u;
    bits = (bits | bits >> 1) & 0x3333u;
    bits = (bits | bits >> 2) & 0x0f0fu;
    return static_cast<int>((bits | bits >> 4) & 0x00ffu);
  };
  return {even_bits(i), even_bits(i >> 1)};
}

}  // namespace bspview
