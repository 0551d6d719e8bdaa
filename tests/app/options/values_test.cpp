#include "app/options/values.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

TEST(ByteSize, UnitsArePowersOf1024InEitherCase) {
  EXPECT_EQ(parse_byte_size("1"), 1u);
  EXPECT_EQ(parse_byte_size("4096b"), 4096u);
  EXPECT_EQ(parse_byte_size("3K"), 3072u);
  EXPECT_EQ(parse_byte_size("512M"), std::size_t{512} << 20);
  EXPECT_EQ(parse_byte_size("2g"), std::size_t{2} << 30);
  EXPECT_EQ(parse_byte_size("1.5GiB"), std::size_t{3} << 29);
  EXPECT_EQ(parse_byte_size("1TB"), std::size_t{1} << 40);
}

TEST(ByteSize, WhatIsNoSizeIsRefused) {
  for (const char* text : {"", "M", "-1M", "0", "1X", "1 M", "1MM", "1Mi", "1e3", "nan", "inf",
                           "1..5K", "99999999999999999999T"}) {
    EXPECT_FALSE(parse_byte_size(text)) << text;
  }
}

TEST(PictureSize, IsWidthTimesHeight) {
  EXPECT_EQ(parse_picture_size("640x480"), (PictureSize{640, 480}));
  EXPECT_EQ(parse_picture_size("1x32768"), (PictureSize{1, 32768}));
}

TEST(PictureSize, WhatIsNoSizeIsRefused) {
  for (const char* text :
       {"", "640", "x", "640x", "x480", "0x480", "640x-1", "640X480", "640x480x3", "32769x1",
        "99999999999x1", "32768x32768", " 640x480", "640 x 480"}) {
    EXPECT_FALSE(parse_picture_size(text)) << text;
  }
}

TEST(FiniteNumber, IsFiniteAndInRange) {
  CLI::Validator validator = finite_number(0.0, 2.0);
  for (std::string text : {"0", "2", "1.5", "1e-3"}) EXPECT_EQ(validator(text), "") << text;
  for (std::string text : {"-1", "2.1", "nan", "inf", "1x", "", "one"}) {
    EXPECT_NE(validator(text), "") << text;
  }
}

TEST(WholeNumber, IsWrittenOutInDigits) {
  CLI::Validator validator = whole_number(1, 20'000'000);
  for (std::string text : {"1000", "1e3", "0.1e4"}) {
    EXPECT_EQ(validator(text), "");
    EXPECT_EQ(text, "1000");
  }
  for (std::string text :
       {"0", "2.5", "1e-3", "2e7x", "20000001", "1e30", "nan", "inf", "", "-1"}) {
    EXPECT_NE(validator(text), "") << text;
  }
  std::string text = "0";
  EXPECT_EQ(validator(text), "'0' is no whole number from 1 to 20000000");
}

}  // namespace
}  // namespace bspview
