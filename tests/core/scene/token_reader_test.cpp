#include "core/scene/token_reader.h"

#include <gtest/gtest.h>

#include <vector>

namespace bspview {
namespace {

std::vector<std::string> tokens_of(std::string_view text) {
  TokenReader reader(text, "f");
  std::vector<std::string> tokens;
  while (!reader.peek().empty()) tokens.emplace_back(reader.take());
  return tokens;
}

TEST(TokenReader, WhiteSpaceCommentsAndByteOrderMarkAreNoTokens) {
  const std::vector<std::string> ab = {"a", "b"};
  for (const std::string_view text : {"a b", " a\tb ", "a\nb\n", "a\r\nb\r\n", "a\rb",
                                      "\xEF\xBB\xBF"
                                      "a b",
                                      "a#x y\nb", "#\na\n#\nb", "a # b\r b", "\n\n#c # d\n\va\fb#"})
    EXPECT_EQ(tokens_of(text), ab) << text;
  EXPECT_TRUE(tokens_of("").empty());
  EXPECT_TRUE(tokens_of(" \n# nothing").empty());
}

TEST(TokenReader, ReadsNumbersAsTheyAreWritten) {
  const std::pair<std::string_view, float> numbers[] = {{"1", 1.0f},
                                                        {"-1.5", -1.5f},
                                                        {"+2", 2.0f},
                                                        {".5", 0.5f},
                                                        {"-.5", -0.5f},
                                                        {"+.5e1", 5.0f},
                                                        {"3.", 3.0f},
                                                        {"1e-3", 1e-3f},
                                                        {"1E+05", 1e5f},
                                                        {"0.1", 0.1f},
                                                        {"16777217", 16777216.0f},
                                                        {"3.4e38", 3.4e38f},
                                                        {"1e-45", 1e-45f},
                                                        {"1e-60", 0.0f},
                                                        {"-1e-400", 0.0f},
                                                        {"0.0000000001e-400", 0.0f}};
  for (const auto& [text, value] : numbers) {
    TokenReader reader(text, "f");
    float read = -1.0f;
    EXPECT_TRUE(reader.number_follows()) << text;
    EXPECT_TRUE(reader.read_float(read, "x")) << text;
    EXPECT_EQ(read, value) << text;
  }
  const std::string tiny = "0." + std::string(500, '0') + "1";
  TokenReader reader(tiny, "f");
  float read = -1.0f;
  EXPECT_TRUE(reader.read_float(read, "x"));
  EXPECT_EQ(read, 0.0f);
}

TEST(TokenReader, RefusesWhatIsNoFiniteFloat) {
  const std::string huge(500, '9');
  for (const std::string_view text :
       {"",      "x",  "nan", "-inf",  "infinity", "1e39",      "-3.5e38",
        "1e400", "1x", "1,5", "1.2.3", "--1",      "+-1",       "+",
        "-",     ".",  "e5",  "0x10",  "1e",       huge.c_str()}) {
    TokenReader reader(text, "f");
    float read = -1.0f;
    EXPECT_FALSE(reader.read_float(read, "x")) << text;
  }
}

TEST(TokenReader, RefusesWhatIsNoCount) {
  for (const std::string_view text :
       {"", "x", "2", "-5", "3.0", "1e3", "99999999999999999999", "3x"}) {
    TokenReader reader(text, "f");
    std::int64_t count = 0;
    EXPECT_FALSE(reader.read_count(count, 3, "a count")) << text;
  }
  TokenReader reader("+12", "f");
  std::int64_t count = 0;
  EXPECT_TRUE(reader.read_count(count, 3, "a count"));
  EXPECT_EQ(count, 12);
}

TEST(TokenReader, AnErrorNamesTheLineWhateverEndsIt) {
  for (const std::string_view text :
       {"1\n2\nx", "1\r2\rx", "1\r\n2\r\nx", "\n\r\nx", "#a\n#b\nx # c\n", "1 2\n\n  x 4\n5\n"}) {
    TokenReader reader(text, "a.nff");
    while (reader.number_follows()) reader.take();
    float value = 0.0f;
    EXPECT_FALSE(reader.read_float(value, "the radius"));
    EXPECT_EQ(reader.error().message, "a.nff:3: expected the radius, found `x`") << text;
  }
}

TEST(TokenReader, TheFirstErrorStaysAndNothingIsReadAfterIt) {
  TokenReader reader("x 1\ny", "f");
  float value = 0.0f;
  EXPECT_FALSE(reader.read_float(value, "the radius"));
  EXPECT_FALSE(reader.read_float(value, "the height"));
  EXPECT_EQ(reader.error().message, "f:1: expected the radius, found `x`");
  EXPECT_EQ(reader.bytes_left(), 0u);
}

TEST(TokenReader, AnErrorShowsNothingThatATerminalObeys) {
  TokenReader reader("\x1b[2J\x80\x01", "f");
  float value = 0.0f;
  EXPECT_FALSE(reader.read_float(value, "a number"));
  EXPECT_EQ(reader.error().message, "f:1: expected a number, found `?[2J??`");

  const std::string token(1000, 'y');
  TokenReader long_reader(token, "f");
  EXPECT_FALSE(long_reader.read_float(value, "a number"));
  EXPECT_LT(long_reader.error().message.size(), 100u);
}

}  // namespace
}  // namespace bspview
