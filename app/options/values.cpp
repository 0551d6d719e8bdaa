#include "app/options/values.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace bspview {
namespace {

/// The whole of `text` as a number.
template <class T, class... Format>
std::optional<T> parse_number(std::string_view text, Format... format) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, format...);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

/// Takes the unit off the end of `text`: 1, 1024, ...
std::optional<double> take_unit(std::string_view& text) {
  const std::size_t end = text.find_last_of("0123456789.") + 1;
  const std::string unit = CLI::detail::to_lower(std::string(text.substr(end)));
  text = text.substr(0, end);
  if (unit.empty() || unit == "b") return 1.0;
  const std::size_t power = std::string_view("kmgt").find(unit.front());
  const std::string_view rest = std::string_view(unit).substr(1);
  if (power == std::string_view::npos || !(rest.empty() || rest == "b" || rest == "ib")) {
    return std::nullopt;
  }
  return std::pow(1024.0, static_cast<double>(power) + 1.0);
}

}  // namespace

std::optional<std::size_t> parse_byte_size(std::string_view text) {
  const std::optional<double> unit = take_unit(text);
  const std::optional<double> number = parse_number<double>(text, std::chars_format::fixed);
  if (!unit || !number) return std::nullopt;
  const double bytes = *number * *unit;
  if (!(bytes >= 1.0 && bytes < std::ldexp(1.0, 63))) return std::nullopt;
  return static_cast<std::size_t>(bytes);
}

std::optional<PictureSize> parse_picture_size(std::string_view text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = parse_number<int>(text.substr(0, cross));
  const auto height = parse_number<int>(text.substr(cross + 1));
  if (!width || !height) return std::nullopt;
  const auto in_range = [](int side) { return side >= 1 && side <= picture_side_cap; };
  if (!in_range(*width) || !in_range(*height)) return std::nullopt;
  if (std::int64_t{*width} * *height > picture_pixel_cap) return std::nullopt;
  return PictureSize{*width, *height};
}

CLI::Option* add_picture_size(CLI::App& app, const std::string& name,
                              std::optional<PictureSize>& size) {
  const auto set = [name, &size](const std::string& text) {
    size = parse_picture_size(text);
    if (size) return;
    throw CLI::ValidationError(
        name, fmt::format("'{}' is no size; write WIDTHxHEIGHT in pixels, each 1 to {}, {} in all",
                          text, picture_side_cap, picture_pixel_cap));
  };
  return app.add_option_function<std::string>(name, set)->type_name("WxH");
}

CLI::Option* add_switch(CLI::App& app, const std::string& name, std::optional<bool>& on) {
  const auto set = [name, &on](const std::string& text) {
    if (text != "on" && text != "off") {
      throw CLI::ValidationError(name, fmt::format("'{}' is neither on nor off", text));
    }
    on = text == "on";
  };
  return app.add_option_function<std::string>(name, set)->type_name("on|off");
}

CLI::Validator finite_number(double least, double most) {
  const auto check = [least, most](const std::string& text) {
    const std::optional<double> value = parse_number<double>(text);
    if (value && *value >= least && *value <= most) return std::string();
    return fmt::format("'{}' is no number from {} to {}", text, least, most);
  };
  return CLI::Validator(check, "");
}

CLI::Validator whole_number(std::int64_t least, std::int64_t most) {
  const auto write_out = [least, most](std::string& text) {
    const std::optional<double> value = parse_number<double>(text);
    const bool in_range = value && *value >= static_cast<double>(least) &&
                          *value <= static_cast<double>(most) && *value == std::floor(*value);
    if (!in_range) return fmt::format("'{}' is no whole number from {} to {}", text, least, most);
    text = fmt::format("{:.0f}", *value);
    return std::string();
  };
  return CLI::Validator(write_out, "");
}

}  // namespace bspview
