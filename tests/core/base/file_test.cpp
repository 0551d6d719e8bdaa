#include "core/base/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

namespace bspview {
namespace {

namespace fs = std::filesystem;

class File : public ::testing::Test {
 protected:
  File() {
    std::string name = (fs::temp_directory_path() / "bspview_file_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~File() override { fs::remove_all(folder_); }

  fs::path folder_;
};

TEST_F(File, ReadsWhatWasWritten) {
  const std::string bytes(200000, 'x');
  ASSERT_TRUE(write_file(folder_ / "a", bytes).ok());
  EXPECT_EQ(*read_file(folder_ / "a"), bytes);
}

TEST_F(File, ReplacesTheOldContentAndKeepsItsPermissions) {
  ASSERT_TRUE(write_file(folder_ / "a", "a longer text").ok());
  ::chmod((folder_ / "a").c_str(), 0640);
  ASSERT_TRUE(write_file(folder_ / "a", "short").ok());
  EXPECT_EQ(*read_file(folder_ / "a"), "short");
  EXPECT_EQ(fs::status(folder_ / "a").permissions(), fs::perms(0640));
}

TEST_F(File, LeavesNoTemporaryFileBehind) {
  ASSERT_TRUE(write_file(folder_ / "a", "text").ok());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(File, WritesThroughALinkWhichStays) {
  ASSERT_TRUE(write_file(folder_ / "a", "old").ok());
  fs::create_symlink(folder_ / "a", folder_ / "link");
  ASSERT_TRUE(write_file(folder_ / "link", "new").ok());
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(*read_file(folder_ / "a"), "new");
}

TEST_F(File, WritesUnderTheLongestNameThereIs) {
  const auto file = folder_ / std::string(255, 'a');
  EXPECT_TRUE(write_file(file, "long").ok());
  EXPECT_EQ(*read_file(file), "long");
}

TEST_F(File, WritesADeviceInPlace) {
  EXPECT_TRUE(write_file("/dev/null", "text").ok());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const Result<void> full = write_file("/dev/full", "text");
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error().message, "/dev/full: cannot be written: No space left on device");
}

TEST_F(File, NamesTheFileThatFails) {
  const std::string missing = (folder_ / "none" / "a").string();
  EXPECT_EQ(read_file(missing).error().message,
            missing + ": cannot be opened: No such file or directory");
  EXPECT_EQ(write_file(missing, "").error().message,
            missing + ": cannot be created: No such file or directory");
  EXPECT_EQ(check_writable(missing).error().message,
            missing + ": cannot be written: No such file or directory");
  EXPECT_EQ(read_file(folder_).error().message, folder_.string() + ": is a folder, not a file");
  EXPECT_EQ(write_file(folder_, "").error().message,
            folder_.string() + ": is a folder, not a file");
}

TEST_F(File, KnowsBeforehandWhereItCanWrite) {
  EXPECT_TRUE(check_writable(folder_ / "new").ok());
  EXPECT_TRUE(check_writable("/dev/null").ok());
  EXPECT_TRUE(check_writable("in_the_current_folder").ok());
  EXPECT_FALSE(check_writable(folder_).ok());
}

}  // namespace
}  // namespace bspview
