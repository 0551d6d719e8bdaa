#include "core/scene/token_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace bspview {
namespace {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

bool ends_token(char c) {
  return is_space(c) || c == '#';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Without a leading plus sign, which from_chars does not know.
std::string_view unsigned_plus(std::string_view token) {
  const bool plus = token.size() > 1 && token[0] == '+' && (is_digit(token[1]) || token[1] == '.');
  return plus ? token.substr(1) : token;
}

/// Whether the value of a number that double cannot hold is too small rather than too large.
bool is_tiny(std::string_view token) {
  const std::size_t exponent = token.find_first_of("eE");
  if (exponent != token.npos) return token.substr(exponent + 1).starts_with('-');
  const std::size_t digit = token.find_first_not_of("-0");
  return digit != token.npos && token[digit] == '.';
}

/// The finite float nearest to the whole token.
std::optional<float> find_float(std::string_view token) {
  token = unsigned_plus(token);
  const char* const end = token.data() + token.size();
  float value = 0.0f;
  const auto [rest, fault] = std::from_chars(token.data(), end, value);
  if (rest != end) return std::nullopt;
  if (fault == std::errc()) return std::isfinite(value) ? std::optional(value) : std::nullopt;
  if (fault != std::errc::result_out_of_range) return std::nullopt;
  double wide = 0.0;
  if (std::from_chars(token.data(), end, wide).ec != std::errc())
    return is_tiny(token) ? std::optional(0.0f) : std::nullopt;
  return std::abs(wide) < 1.0 ? std::optional(static_cast<float>(wide)) : std::nullopt;
}

/// A token as a message shows it: short, and without what a terminal might obey.
std::string shown(std::string_view token) {
  constexpr std::size_t longest = 32;
  std::string text(token.substr(0, longest));
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return '`' + text + (token.size() > longest ? "...`" : "`");
}

std::size_t line_of(std::string_view text, std::size_t position) {
  std::size_t line = 1;
  for (std::size_t i = 0; i < position; ++i)
    if (text[i] == '\n' || (text[i] == '\r' && text.substr(i, 2) != "\r\n")) ++line;
  return line;
}

}  // namespace

TokenReader::TokenReader(std::string_view text, std::string file_name)
    : text_(text), file_name_(std::move(file_name)) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
  token_ = text_.substr(0, 0);
}

void TokenReader::skip_space() {
  bool in_comment = false;
  for (; position_ < text_.size(); ++position_) {
    const char c = text_[position_];
    if (c == '#') in_comment = true;
    if (is_line_end(c)) in_comment = false;
    if (!in_comment && !is_space(c)) return;
  }
}

std::string_view TokenReader::peek() {
  skip_space();
  std::size_t end = position_;
  while (end < text_.size() && !ends_token(text_[end])) ++end;
  return text_.substr(position_, end - position_);
}

std::string_view TokenReader::take() {
  token_ = peek();
  position_ += token_.size();
  return token_;
}

bool TokenReader::number_follows() {
  const std::string_view token = peek();
  return !token.empty() && (is_digit(token[0]) || token.find_first_of("+-.") == 0);
}

bool TokenReader::read_float(float& value, std::string_view what) {
  const std::optional<float> number = find_float(take());
  if (!number) return fail_expecting(what);
  value = *number;
  return true;
}

bool TokenReader::read_vec3(Vec3& value, std::string_view what) {
  return read_float(value.x, what) && read_float(value.y, what) && read_float(value.z, what);
}

bool TokenReader::read_count(std::int64_t& value, std::int64_t smallest, std::string_view what) {
  const std::string_view digits = unsigned_plus(take());
  const char* const end = digits.data() + digits.size();
  const auto [rest, fault] = std::from_chars(digits.data(), end, value);
  if (fault != std::errc() || rest != end) return fail_expecting(what);
  if (value >= smallest) return true;
  return fail_expecting(std::string(what) + ", at least " + std::to_string(smallest));
}

bool TokenReader::fail_expecting(std::string_view what) {
  const std::string found = token_.empty() ? "the end of the file" : shown(token_);
  return fail("expected " + std::string(what) + ", found " + found);
}

bool TokenReader::fail(std::string sentence) {
  if (!error_.message.empty()) return false;
  const auto token_start = static_cast<std::size_t>(token_.data() - text_.data());
  const std::size_t line = line_of(text_, token_start);
  error_.message = file_name_ + ':' + std::to_string(line) + ": " + std::move(sentence);
  position_ = text_.size();
  return false;
}

}  // namespace bspview
