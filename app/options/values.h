#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "app/picture_size.h"

namespace bspview {

/// "512M", "2G", "1.5GiB", "4096": bytes, with K, M, G and T the powers of 1024.
std::optional<std::size_t> parse_byte_size(std::string_view text);

inline constexpr int picture_side_cap = 32768;
inline constexpr std::int64_t picture_pixel_cap = std::int64_t{1} << 27;

/// "640x480", both sides 1 to picture_side_cap, at most picture_pixel_cap in all.
std::optional<PictureSize> parse_picture_size(std::string_view text);

/// Options of `app` whose values are WxH, and on or off.
CLI::Option* add_picture_size(CLI::App& app, const std::string& name,
                              std::optional<PictureSize>& size);
CLI::Option* add_switch(CLI::App& app, const std::string& name, std::optional<bool>& on);

/// Accepts finite numbers from `least` to `most`.
CLI::Validator finite_number(double least, double most);

/// For CLI::Option::transform: accepts whole numbers from `least` to `most`, "1e6", too, and writes
/// their digits out.
CLI::Validator whole_number(std::int64_t least, std::int64_t most);

}  // namespace bspview
