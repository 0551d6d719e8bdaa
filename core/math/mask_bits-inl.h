// Masks of vectors as bits, and back. Included once for every instruction set that Highway
// (hwy/foreach_target.h) compiles for.

#if defined(BSPVIEW_MASK_BITS) == defined(HWY_TARGET_TOGGLE)
#ifdef BSPVIEW_MASK_BITS
#undef BSPVIEW_MASK_BITS
#else
#define BSPVIEW_MASK_BITS
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One bit a lane, of up to 16.
template <class Tag>
HWY_INLINE unsigned bits_of(Tag tag, hn::Mask<Tag> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(tag, mask, bytes);
  if constexpr (std::endian::native == std::endian::little) {
    std::uint16_t bits;  // at once: byte by byte takes longer than many a test
    std::memcpy(&bits, bytes, sizeof bits);
    return bits;
  }
  return bytes[0] | bytes[1] << 8;
}

/// The lanes of a set, as bits_of answers it.
template <class Tag>
HWY_INLINE hn::Mask<Tag> mask_of(Tag tag, unsigned lanes) {
  std::uint8_t bytes[8] = {static_cast<std::uint8_t>(lanes), static_cast<std::uint8_t>(lanes >> 8)};
  if constexpr (std::endian::native == std::endian::little) {
    const auto bits = static_cast<std::uint16_t>(lanes);
    std::memcpy(bytes, &bits, sizeof bits);
  }
  return hn::LoadMaskBits(tag, bytes);
}

}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
