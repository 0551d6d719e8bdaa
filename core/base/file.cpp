#include "core/base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace bspview {
namespace {

namespace fs = std::filesystem;

Error system_error(const fs::path& file, std::string_view what) {
  return Error{fmt::format("{}: {}: {}", file.string(), what, std::strerror(errno))};
}

/// Closes on destruction what close_now() has not closed.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close_now(); }

  bool open() const { return number_ >= 0; }
  int number() const { return number_; }
  bool close_now() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0;
  }

 private:
  int number_;
};

bool write_all(Descriptor& out, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(out.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return out.close_now();
}

Result<void> write_in_place(const fs::path& file, std::string_view bytes) {
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!out.open()) return system_error(file, "cannot be opened for writing");
  if (!write_all(out, bytes)) return system_error(file, "cannot be written");
  return {};
}

/// Permissions of a file that open() would have made, or those of the file that is replaced.
mode_t permissions_for(const fs::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

Result<void> write_and_rename(const fs::path& file, std::string_view bytes) {
  // Not after the file, whose name may already be as long as names can be.
  std::string temporary = (file.parent_path() / ".bspview.XXXXXX").string();
  Descriptor out(::mkostemp(temporary.data(), O_CLOEXEC));
  if (!out.open()) return system_error(file, "cannot be created");
  const bool done = ::fchmod(out.number(), permissions_for(file)) == 0 && write_all(out, bytes) &&
                    ::rename(temporary.c_str(), file.c_str()) == 0;
  if (done) return {};
  const Error error = system_error(file, "cannot be written");
  ::unlink(temporary.c_str());
  return error;
}

/// Where a link leads, so that the link itself stays.
fs::path behind_links(const fs::path& file) {
  std::error_code ignored;
  const fs::path real = fs::canonical(file, ignored);
  return real.empty() ? file : real;
}

}  // namespace

Result<std::string> read_file(const fs::path& file) {
  Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!in.open()) return system_error(file, "cannot be opened");
  struct stat status {};
  if (::fstat(in.number(), &status) == 0 && S_ISDIR(status.st_mode)) {
    return Error{fmt::format("{}: is a folder, not a file", file.string())};
  }
  constexpr std::size_t chunk = std::size_t{1} << 16;
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(status.st_size) + chunk);
  for (std::size_t size = 0;;) {
    bytes.resize(size + chunk);
    const ssize_t got = ::read(in.number(), bytes.data() + size, chunk);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return system_error(file, "cannot be read");
    size += static_cast<std::size_t>(got);
    bytes.resize(size);
    if (got == 0) return bytes;
  }
}

Result<void> write_file(const fs::path& file, std::string_view bytes) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) {
    return Error{fmt::format("{}: is a folder, not a file", file.string())};
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_in_place(file, bytes);
  return write_and_rename(behind_links(file), bytes);
}

Result<void> check_writable(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) {
    return Error{fmt::format("{}: is a folder, not a file", file.string())};
  }
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  const fs::path parent = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const fs::path written = in_place ? file : parent;
  if (::access(written.c_str(), W_OK) != 0) return system_error(file, "cannot be written");
  return {};
}

}  // namespace bspview
