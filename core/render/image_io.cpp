#include "core/render/image_io.h"

#include <fmt/format.h>
#include <stb/stb_image_write.h>
#include <tinyexr.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>

#include "core/base/file.h"

namespace bspview {
namespace {

std::uint8_t to_byte(float value) {
  // The order of the arguments makes 0 of a NaN.
  return static_cast<std::uint8_t>(std::min(std::max(0.0f, value), 1.0f) * 255.0f + 0.5f);
}

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void append_bytes(void* text, void* bytes, int size) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(bytes),
                                          static_cast<std::size_t>(size));
}

/// The picture as the planes that EXR stores, channels in alphabetic order.
struct ExrPlanes {
  std::array<std::vector<float>, 3> blue_green_red;

  explicit ExrPlanes(const Image& image) {
    for (int channel = 0; channel < 3; ++channel) {
      auto& plane = blue_green_red[static_cast<std::size_t>(channel)];
      plane.reserve(image.pixels.size());
      for (const Vec3& pixel : image.pixels) plane.push_back(pixel[2 - channel]);
    }
  }
};

/// Header of a picture of three float channels. tinyexr wants arrays made by malloc only in headers
/// that it frees itself; this one owns its arrays.
struct ExrHeader {
  std::array<EXRChannelInfo, 3> channels{};
  std::array<int, 3> types{TINYEXR_PIXELTYPE_FLOAT, TINYEXR_PIXELTYPE_FLOAT,
                           TINYEXR_PIXELTYPE_FLOAT};
  EXRHeader header;

  ExrHeader() {
    InitEXRHeader(&header);
    for (std::size_t i = 0; i < 3; ++i) channels[i].name[0] = "BGR"[i];
    header.num_channels = 3;
    header.channels = channels.data();
    header.pixel_types = types.data();
    header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  }
};

}  // namespace

Result<void> save_png(const Image& image, const std::filesystem::path& file) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.pixels.size() * 3);
  for (const Vec3& pixel : image.pixels) {
    for (int channel = 0; channel < 3; ++channel) bytes.push_back(to_byte(pixel[channel]));
  }
  std::string png;
  const int done = stbi_write_png_to_func(append_bytes, &png, image.width, image.height, 3,
                                          bytes.data(), image.width * 3);
  if (done == 0) return Error{fmt::format("{}: the picture cannot be encoded", file.string())};
  return write_file(file, png);
}

Result<void> save_exr(const Image& image, const std::filesystem::path& file) {
  ExrPlanes planes(image);
  ExrHeader header;
  std::array<unsigned char*, 3> planes_of;
  std::ranges::transform(planes.blue_green_red, planes_of.begin(), [](std::vector<float>& plane) {
    return reinterpret_cast<unsigned char*>(plane.data());
  });
  EXRImage exr;
  InitEXRImage(&exr);
  exr.num_channels = 3;
  exr.images = planes_of.data();
  exr.width = image.width;
  exr.height = image.height;

  unsigned char* memory = nullptr;
  const char* reason = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&exr, &header.header, &memory, &reason);
  const std::unique_ptr<unsigned char, decltype(&std::free)> owner(memory, &std::free);
  if (size == 0) {
    FreeEXRErrorMessage(reason);
    return Error{fmt::format("{}: the picture cannot be encoded", file.string())};
  }
  return write_file(file, {reinterpret_cast<const char*>(memory), size});
}

bool is_image_name(const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  return extension == ".png" || extension == ".exr";
}

Result<void> save_image(const Image& image, const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".png") return save_png(image, file);
  if (extension == ".exr") return save_exr(image, file);
  return Error{fmt::format("{}: a picture is written as .png or .exr", file.string())};
}

}  // namespace bspview
