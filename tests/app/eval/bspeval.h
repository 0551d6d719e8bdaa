#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace bspview::test {

/// What one run of the program did.
struct Outcome {
  int exit_code = -1;
  std::string out, err;
};

/// Runs the real bspeval in an empty folder of its own.
class Bspeval : public ::testing::Test {
 protected:
  Bspeval();
  ~Bspeval() override;

  /// `arguments` as in a shell, run in the folder.
  Outcome run(const std::string& arguments) const;

  void write(const std::string& file, const std::string& text) const;
  std::string read(const std::string& file) const;
  bool exists(const std::string& file) const { return std::filesystem::exists(folder_ / file); }

  std::filesystem::path folder_;
};

/// A triangle at z = 0 under a sphere of radius 1 around (0, 0, 3), a light and a view from above.
std::string small_scene();

}  // namespace bspview::test
