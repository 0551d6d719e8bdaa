#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace bspview {

/// The whole content of `file`.
Result<std::string> read_file(const std::filesystem::path& file);

/// Writes `bytes` to a temporary file beside `file`, which is then renamed: a failed run leaves
/// what was there before. What is no regular file (a device, a pipe) is written in place.
Result<void> write_file(const std::filesystem::path& file, std::string_view bytes);

/// Whether write_file has a place to write to; cheap, to be asked before long work.
Result<void> check_writable(const std::filesystem::path& file);

}  // namespace bspview
