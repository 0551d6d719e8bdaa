#include "core/render/image_io.h"

#include <gtest/gtest.h>
#include <stb/stb_image.h>
#include <tinyexr.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <memory>

namespace bspview {
namespace {

namespace fs = std::filesystem;

class ImageIo : public ::testing::Test {
 protected:
  ImageIo() {
    std::string name = (fs::temp_directory_path() / "bspview_image_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~ImageIo() override { fs::remove_all(folder_); }

  fs::path folder_;
};

Image gradient(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
      image.pixels.push_back({fx / 40.0f, fy / 30.0f, -0.5f + 0.3f * fx});
    }
  }
  return image;
}

std::vector<unsigned char> read_png(const fs::path& file, int& width, int& height) {
  int channels = 0;
  unsigned char* bytes = stbi_load(file.c_str(), &width, &height, &channels, 3);
  const std::unique_ptr<unsigned char, decltype(&std::free)> owner(bytes, &std::free);
  if (bytes == nullptr) return {};
  return {bytes, bytes + width * height * 3};
}

TEST_F(ImageIo, PngHoldsTheClampedAndRoundedPixelsTopRowFirst) {
  Image image{2, 2, {{0, 0.5f, 1}, {-3, 2, std::nanf("")}, {0.25f, 0.75f, 0.1f}, {1, 1, 1}}};
  ASSERT_TRUE(save_png(image, folder_ / "a.png").ok());
  int width = 0, height = 0;
  const std::vector<unsigned char> expected{0, 128, 255, 0, 255, 0, 64, 191, 26, 255, 255, 255};
  EXPECT_EQ(read_png(folder_ / "a.png", width, height), expected);
  EXPECT_EQ(width, 2);
  EXPECT_EQ(height, 2);
}

TEST_F(ImageIo, ExrKeepsEveryFloat) {
  const Image image = gradient(37, 29);
  ASSERT_TRUE(save_exr(image, folder_ / "a.exr").ok());
  float* rgba = nullptr;
  int width = 0, height = 0;
  const char* reason = nullptr;
  ASSERT_EQ(LoadEXR(&rgba, &width, &height, (folder_ / "a.exr").c_str(), &reason), 0);
  const std::unique_ptr<float, decltype(&std::free)> owner(rgba, &std::free);
  ASSERT_EQ(width, 37);
  ASSERT_EQ(height, 29);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    ASSERT_EQ(image.pixels[i], Vec3(rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2])) << i;
  }
}

TEST_F(ImageIo, TheExtensionChoosesTheFormat) {
  const Image image = gradient(3, 2);
  int width = 0, height = 0;
  EXPECT_TRUE(save_image(image, folder_ / "a.PNG").ok());
  EXPECT_EQ(read_png(folder_ / "a.PNG", width, height).size(), 18u);
  EXPECT_TRUE(save_image(image, folder_ / "a.exr").ok());
  EXPECT_EQ(IsEXR((folder_ / "a.exr").c_str()), 0);
  EXPECT_FALSE(save_image(image, folder_ / "a.jpg").ok());
  EXPECT_FALSE(fs::exists(folder_ / "a.jpg"));
  EXPECT_TRUE(is_image_name("b.Exr"));
  EXPECT_FALSE(is_image_name("png"));
}

TEST_F(ImageIo, AFolderThatIsNotThereIsAnErrorThatNamesTheFile) {
  const std::string file = (folder_ / "none" / "a.png").string();
  const Result<void> result = save_image(gradient(3, 2), file);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().message.rfind(file + ": ", 0), 0u);
}

}  // namespace
}  // namespace bspview
