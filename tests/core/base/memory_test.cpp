#include "core/base/memory.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <new>

#include "core/base/raw_vector.h"

namespace bspview {
namespace {

TEST(RawVector, ItsBytesAreThereToTheLastOne) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, fewest_page_bytes - 1,
                                 fewest_page_bytes, fewest_page_bytes + 1, 3 * fewest_page_bytes}) {
    RawVector<std::byte> bytes(size);
    for (std::size_t i = 0; i < size; i += 4096) bytes[i] = std::byte{1};
    if (size > 0) bytes[size - 1] = std::byte{2};
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(std::max_align_t), 0u);
  }
}

TEST(Memory, MoreThanThereIsIsRefused) {
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
  EXPECT_THROW((void)allocate_pages(most), std::bad_alloc);
  EXPECT_THROW((void)allocate_pages(most / 4), std::bad_alloc);
  RawVector<std::byte> bytes;
  EXPECT_THROW(bytes.resize(most / 4), std::bad_alloc);
}

TEST(RawVector, KeepsItsElementsWhenItGrowsIntoPages) {
  RawVector<std::uint32_t> numbers;
  constexpr std::uint32_t count = 3 * fewest_page_bytes / sizeof(std::uint32_t);
  for (std::uint32_t i = 0; i < count; ++i) numbers.push_back(i);
  for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(numbers[i], i);
  const RawVector<std::uint32_t> copy = numbers;
  numbers.clear();
  numbers.shrink_to_fit();
  EXPECT_EQ(copy.back(), count - 1);
}

}  // namespace
}  // namespace bspview
