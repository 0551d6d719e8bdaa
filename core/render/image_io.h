#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/render/render.h"

namespace bspview {

/// 8 bits a channel: clamped to [0, 1] and rounded; a NaN becomes 0.
Result<void> save_png(const Image& image, const std::filesystem::path& file);

/// 32-bit floats as they are.
Result<void> save_exr(const Image& image, const std::filesystem::path& file);

/// One of the above after the extension of `file`, .png or .exr in either case.
Result<void> save_image(const Image& image, const std::filesystem::path& file);
bool is_image_name(const std::filesystem::path& file);

}  // namespace bspview
