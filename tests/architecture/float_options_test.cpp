#include "tests/architecture/float_options.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace bspview::test {
namespace {

/// How the build compiles each file; the path is relative to the source folder.
struct CompiledFile {
  std::string path, command;
};

std::vector<CompiledFile> compiled_files() {
  std::ifstream stream(std::filesystem::path(BSPVIEW_BINARY_DIR) / "compile_commands.json");
  EXPECT_TRUE(stream.is_open());
  std::vector<CompiledFile> files;
  for (const auto& entry : nlohmann::json::parse(stream)) {
    const std::filesystem::path file = std::string(entry["file"]);
    files.push_back({file.lexically_relative(BSPVIEW_SOURCE_DIR).generic_string(),
                     std::string(entry["command"])});
  }
  return files;
}

/// Definitions and include folders of a command.
std::string meaning_of(const std::string& command) {
  std::string kept;
  bool is_folder = false;
  for (const std::string& word : words_of(command)) {
    const bool wanted = word.starts_with("-D") || word.starts_with("-I") ||
                        word.starts_with("-std=") || word == "-isystem";
    if (wanted || is_folder) kept += " " + word;
    is_folder = word == "-isystem";
  }
  return kept;
}

/// Whether a file that includes `header` compiles with the options of the library and `extra`.
bool compiles(const std::string& header, const std::string& extra) {
  std::string command;
  for (const CompiledFile& file : compiled_files()) {
    if (file.path == "core/shape/triangle.cpp") command = meaning_of(file.command);
  }
  std::erase(command, '\\');
  const std::string run = "echo '#include \"" + header + "\"' | '" + BSPVIEW_COMPILER + "' " +
                          command + " -x c++ -fsyntax-only " + extra + " - 2>/dev/null";
  return std::system(run.c_str()) == 0;
}

TEST(FloatOptions, NothingOfOursIsCompiledWithLooseFloats) {
  std::size_t ours = 0;
  for (const CompiledFile& file : compiled_files()) {
    const bool wrong_on_purpose = file.path.starts_with("tests/mutants/");
    if (file.path.starts_with("..") || wrong_on_purpose) continue;
    EXPECT_EQ(find_loose_floats(file.command).value_or(""), "") << file.path;
    ++ours;
  }
  EXPECT_GT(ours, 50u);
}

TEST(FloatOptions, LooseOnesAreFound) {
  EXPECT_FALSE(find_loose_floats("c++ -O3 -ffp-contract=off -c a.cpp"));
  EXPECT_FALSE(find_loose_floats("c++ -ffp-contract=fast -ffp-contract=off -c a.cpp"));
  EXPECT_TRUE(find_loose_floats("c++ -O3 -c a.cpp"));
  EXPECT_TRUE(find_loose_floats("c++ -ffp-contract=off -ffp-contract=fast -c a.cpp"));
  EXPECT_EQ(find_loose_floats("c++ -ffp-contract=off -ffast-math -c a.cpp"), "-ffast-math");
  EXPECT_EQ(find_loose_floats("c++ -ffp-contract=off -Ofast -c a.cpp"), "-Ofast");
  EXPECT_TRUE(find_loose_floats("c++ -ffp-contract=off -fno-signed-zeros -c a.cpp"));
}

TEST(FloatOptions, WhatDecidesHitsDoesNotCompileWithThem) {
  for (const char* header :
       {"core/shape/triangle.h", "core/bsp/traverse_robust.h", "core/math/exact.h"}) {
    EXPECT_TRUE(compiles(header, "")) << header;
    EXPECT_FALSE(compiles(header, "-ffast-math")) << header;
    EXPECT_FALSE(compiles(header, "-UBSPVIEW_NO_CONTRACTION")) << header;
  }
  for (const char* option : {"-Ofast", "-ffinite-math-only"}) {
    EXPECT_FALSE(compiles("core/shape/sphere.h", option)) << option;
  }
}

}  // namespace
}  // namespace bspview::test
