#include "tests/gui/window/stage_play.h"

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace bspview {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto longest_wait = 60s;
constexpr auto look_again = 10ms;

std::string text_of(const std::string& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string words_of(Vec2 point, int axis) {
  return std::to_string(static_cast<int>(axis == 0 ? point.x : point.y));
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "bspview_play_XXXXXX").string();
  path_ = mkdtemp(name.data());
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

VirtualDisplay::VirtualDisplay(const TemporaryFolder& folder,
                               const std::vector<std::string>& options) {
  // The server takes a free number and writes it to its standard output. With -noreset it outlives
  // its first client.
  std::vector<std::string> words{"Xvfb",        "-displayfd", "1",         "-screen", "0",
                                 "1280x800x24", "-noreset",   "-nolisten", "tcp"};
  words.insert(words.end(), options.begin(), options.end());
  const std::string output = folder.file("display");
  server_ = std::make_unique<ChildProcess>(words, std::map<std::string, std::string>{}, output);
  const Clock::time_point end = Clock::now() + longest_wait;
  while (name_.empty() && server_->running() && Clock::now() < end) {
    std::this_thread::sleep_for(look_again);
    const std::string text = text_of(output);
    const std::size_t line_end = text.rfind('\n');
    if (line_end == std::string::npos) continue;
    const std::size_t line = text.find_last_of('\n', line_end - 1) + 1;
    if (text.find_first_not_of("0123456789", line) == line_end)
      name_ = ":" + text.substr(line, line_end - line);
  }
}

StagePlay::StagePlay(const std::vector<std::string>& arguments,
                     const std::vector<std::string>& server_options)
    : display_(folder_, server_options) {
  environment_ = {{"DISPLAY", display_.name()},
                  {"WAYLAND_DISPLAY", ""},
                  {"XDG_CONFIG_HOME", folder_.file("config")},
                  {"HOME", folder_.path().string()}};
  client_ = std::make_unique<XClient>(display_.name());
  std::vector<std::string> words{BSPVIEW_PROGRAM, "--state", folder_.file("state.json"), "--ui-map",
                                 folder_.file("widgets.json")};
  words.insert(words.end(), arguments.begin(), arguments.end());
  program_ = std::make_unique<ChildProcess>(words, environment_, folder_.file("output"));
}

bool StagePlay::wait_for(const std::function<bool(const nlohmann::json&)>& test) {
  const Clock::time_point end = Clock::now() + longest_wait;
  while (Clock::now() < end && program_->running()) {
    state_ = nlohmann::json::parse(text_of(folder_.file("state.json")), nullptr, false);
    if (state_.is_object() && test(state_)) return true;
    std::this_thread::sleep_for(look_again);
  }
  return false;
}

bool StagePlay::wait_until_idle() {
  return wait_for([](const nlohmann::json& state) {
    return !state["busy"] && (!state["picture"].is_null() || !state["scene"]["error"].is_null());
  });
}

Vec2 StagePlay::point_of(const std::string& widget, float share) const {
  const auto widgets = nlohmann::json::parse(text_of(folder_.file("widgets.json")), nullptr, false);
  const auto rect = widgets.value(widget, std::vector<float>{0, 0, 0, 0});
  return {rect[0] + share * rect[2], rect[1] + rect[3] / 2};
}

void StagePlay::user(const std::vector<std::string>& words) {
  std::vector<std::string> all{"xdotool"};
  all.insert(all.end(), words.begin(), words.end());
  run(all, environment_, folder_.file("xdotool"));
}

void StagePlay::user_moves(Vec2 to) {
  user({"mousemove", words_of(to, 0), words_of(to, 1)});
}

std::string StagePlay::output() const {
  return text_of(folder_.file("output"));
}

}  // namespace bspview
