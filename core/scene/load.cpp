#include "core/scene/load.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <new>
#include <string>
#include <string_view>

#include "core/scene/spd.h"

namespace bspview {
namespace {

struct Format {
  std::string_view extension;  // lower case
  Result<Scene> (*load)(const std::filesystem::path&);
};

constexpr Format formats[] = {{".nff", load_nff}};

constexpr std::string_view spd_prefix = "spd:";

/// `NAME` or `NAME:SIZE`.
Result<Scene> load_spd(std::string_view name_and_size) {
  const std::size_t colon = name_and_size.find(':');
  const std::string_view name = name_and_size.substr(0, colon);
  if (colon == name_and_size.npos) return make_spd(name);
  const std::string_view digits = name_and_size.substr(colon + 1);
  int size = 0;
  const char* const end = digits.data() + digits.size();
  const auto [rest, fault] = std::from_chars(digits.data(), end, size);
  if (fault == std::errc() && rest == end) return make_spd(name, size);
  return Error{"spd:" + std::string(name_and_size) + ": `" + std::string(digits) +
               "` is no size factor, which is a whole number"};
}

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : static_cast<char>(c);
  });
  return extension;
}

Error unknown_format(const std::filesystem::path& file, const std::string& extension) {
  std::string known;
  for (const Format& format : formats) known += std::string(format.extension) + ", ";
  const std::string found = extension.empty() ? "no extension" : "the extension " + extension;
  return Error{file.string() + ": has " + found + ", which names no scene format (" + known +
               "or spd:NAME[:SIZE] for a standard scene)"};
}

}  // namespace

Result<Scene> load_scene(const std::string& source) {
  if (source.empty()) return Error{"the name of the scene is empty"};
  if (source.starts_with(spd_prefix)) return load_spd(source.substr(spd_prefix.size()));
  const std::filesystem::path file(source);
  std::error_code none;
  // Said before the extension: a wrong name is the likelier mistake.
  const std::filesystem::file_status status = std::filesystem::status(file, none);
  if (status.type() == std::filesystem::file_type::not_found)
    return Error{source + ": there is no such file"};
  if (std::filesystem::is_directory(status)) return Error{source + ": is a folder, not a scene"};
  const std::string extension = extension_of(file);
  const auto* const format = std::ranges::find(formats, extension, &Format::extension);
  if (format == std::end(formats)) return unknown_format(file, extension);
  try {
    return format->load(file);
  } catch (const std::bad_alloc&) {
    return Error{source + ": needs more memory than there is"};
  }
}

}  // namespace bspview
