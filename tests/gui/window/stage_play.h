#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/math/vec.h"
#include "tests/gui/window/child_process.h"
#include "tests/gui/window/x_client.h"

namespace bspview {

/// A folder that vanishes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// An X server without a screen.
class VirtualDisplay {
 public:
  explicit VirtualDisplay(const TemporaryFolder& folder,
                          const std::vector<std::string>& options = {});
  /// ":7"; "" when the server did not start.
  const std::string& name() const { return name_; }

 private:
  std::unique_ptr<ChildProcess> server_;
  std::string name_;
};

/// The real program on a virtual display, with a user who points, types and drops files. It is
/// watched through the state and the widgets that it exports.
class StagePlay {
 public:
  StagePlay(const std::vector<std::string>& arguments,
            const std::vector<std::string>& server_options = {});

  /// Waits until the exported state passes `test`; false after a minute, or when the program ended.
  bool wait_for(const std::function<bool(const nlohmann::json&)>& test);
  bool wait_until_idle();
  const nlohmann::json& state() const { return state_; }

  /// Point of a widget, `share` of its width from the left, in window coordinates.
  Vec2 point_of(const std::string& widget, float share = 0.5f) const;
  /// Runs xdotool with these words.
  void user(const std::vector<std::string>& words);
  void user_moves(Vec2 to);

  XClient& client() { return *client_; }
  ChildProcess& program() { return *program_; }
  const TemporaryFolder& folder() const { return folder_; }
  std::string output() const;

 private:
  TemporaryFolder folder_;
  VirtualDisplay display_;
  std::map<std::string, std::string> environment_;
  std::unique_ptr<XClient> client_;
  std::unique_ptr<ChildProcess> program_;
  nlohmann::json state_;
};

}  // namespace bspview
