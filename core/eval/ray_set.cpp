#include "core/eval/ray_set.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>

namespace bspview {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// The next token of `line`, which is shortened by it; empty at the end.
std::string_view take_token(std::string_view& line) {
  std::size_t start = 0;
  while (start < line.size() && is_space(line[start])) ++start;
  std::size_t end = start;
  while (end < line.size() && !is_space(line[end])) ++end;
  const std::string_view token = line.substr(start, end - start);
  line.remove_prefix(end);
  return token;
}

/// One correctly rounded float, the whole of `digits`; what is beyond the floats becomes inf or 0.
std::optional<float> parse_digits(std::string_view digits, std::chars_format format) {
  const char* end = digits.data() + digits.size();
  float value = 0.0f;
  const auto [stop, error] = std::from_chars(digits.data(), end, value, format);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc()) return value;
  const std::string_view prefix = format == std::chars_format::hex ? "0x" : "";
  return std::strtof(fmt::format("{}{}", prefix, digits).c_str(), nullptr);
}

std::optional<float> parse_float(std::string_view token) {
  const bool negative = token.starts_with('-');
  if (negative || token.starts_with('+')) token.remove_prefix(1);
  const bool hexadecimal = token.starts_with("0x") || token.starts_with("0X");
  if (hexadecimal) token.remove_prefix(2);
  if (token.empty() || token.front() == '-') return std::nullopt;
  const auto format = hexadecimal ? std::chars_format::hex : std::chars_format::general;
  const std::optional<float> value = parse_digits(token, format);
  if (!value) return std::nullopt;
  return negative ? -*value : *value;
}

/// The numbers of one line, or what is wrong with it.
struct Line {
  std::array<float, 8> numbers{};
  std::size_t count = 0;
  std::string problem;
};

Line parse_line(std::string_view text) {
  Line line;
  for (std::string_view token = take_token(text); !token.empty(); token = take_token(text)) {
    const std::optional<float> number = parse_float(token);
    if (!number) {
      line.problem = fmt::format("'{}' is no number", token.substr(0, 40));
      return line;
    }
    if (line.count < line.numbers.size()) line.numbers[line.count] = *number;
    ++line.count;
  }
  if (line.count != 0 && line.count != 6 && line.count != 8) {
    line.problem = fmt::format("a ray has 6 or 8 numbers, not {}", line.count);
  } else if (line.numbers[6] < 0.0f) {
    line.problem =
        fmt::format("tmin is {}: rays do not start behind their origin", line.numbers[6]);
  }
  return line;
}

Ray make_ray(const Line& line) {
  const auto& n = line.numbers;
  Ray ray{.origin = {n[0], n[1], n[2]}, .direction = {n[3], n[4], n[5]}};
  if (line.count == 8) {
    ray.t_min = n[6];
    ray.t_max = n[7];
  }
  return ray;
}

}  // namespace

Result<std::vector<Ray>> parse_rays(std::string_view text, const std::string& file_name) {
  std::vector<Ray> rays;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view content = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const Line line = parse_line(content.substr(0, content.find('#')));
    if (!line.problem.empty()) {
      return Error{fmt::format("{}:{}: {}", file_name, number, line.problem)};
    }
    if (line.count != 0) rays.push_back(make_ray(line));
  }
  return rays;
}

std::string format_results(std::span<const RayResult> results) {
  fmt::memory_buffer text;
  for (const RayResult& result : results) {
    if (result.object == no_index) {
      text.append(std::string_view("-1 inf\n"));
    } else {
      fmt::format_to(std::back_inserter(text), "{} {:.9g}\n", result.object, result.t);
    }
  }
  return fmt::to_string(text);
}

std::string format_occlusion(std::span<const RayResult> results) {
  std::string text;
  text.reserve(results.size() * 2);
  for (const RayResult& result : results) text += result.object == no_index ? "0\n" : "1\n";
  return text;
}

}  // namespace bspview
