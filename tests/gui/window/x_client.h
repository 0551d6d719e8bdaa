#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace bspview {

/// Another program on the same X display: looks at the pixels and drops files on windows.
class XClient {
 public:
  explicit XClient(const std::string& display);
  ~XClient();
  XClient(const XClient&) = delete;
  XClient& operator=(const XClient&) = delete;

  bool connected() const;
  /// The whole screen, row-major, red in the highest of the lower three bytes.
  std::vector<std::uint32_t> screen();
  /// Drags `file` from another program on the first window that takes drops, and lets it go there
  /// (XDND, freedesktop.org/wiki/Specifications/XDND). False when nothing took it within a minute.
  bool drop(const std::string& file);

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace bspview
