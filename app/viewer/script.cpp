#include "app/viewer/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <sstream>

#include "app/viewer/key.h"

namespace bspview {
namespace {

struct Command {
  std::string_view name;
  ScriptStep::Kind kind;
};
constexpr std::array commands{
    Command{"wait", ScriptStep::Kind::wait},
    Command{"move", ScriptStep::Kind::move},
    Command{"press", ScriptStep::Kind::press},
    Command{"release", ScriptStep::Kind::release},
    Command{"click", ScriptStep::Kind::click},
    Command{"wheel", ScriptStep::Kind::wheel},
    Command{"key", ScriptStep::Kind::key},
    Command{"type", ScriptStep::Kind::type},
    Command{"drop", ScriptStep::Kind::drop},
    Command{"state", ScriptStep::Kind::state},
    Command{"screenshot", ScriptStep::Kind::screenshot},
};

struct NamedKey {
  std::string_view name;
  int code;
};
constexpr std::array named_keys{
    NamedKey{"ctrl", key::left_control},
    NamedKey{"shift", key::left_shift},
    NamedKey{"alt", key::left_alt},
    NamedKey{"esc", key::escape},
    NamedKey{"tab", key::tab},
    NamedKey{"enter", key::enter},
    NamedKey{"left", key::left},
    NamedKey{"right", key::right},
    NamedKey{"up", key::up},
    NamedKey{"down", key::down},
};

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<float> number(const std::string& text) {
  std::istringstream stream(text);
  float value = 0.0f;
  if (stream >> value && stream.eof()) return value;
  return std::nullopt;
}

std::optional<int> key_code(const std::string& name) {
  const std::string small = lower(name);
  const auto found = std::ranges::find(named_keys, small, &NamedKey::name);
  if (found != named_keys.end()) return found->code;
  if (small.size() == 1) return std::toupper(static_cast<unsigned char>(small[0]));
  const auto function = small[0] == 'f' ? number(small.substr(1)) : std::nullopt;
  if (function && *function >= 1.0f && *function <= 12.0f)
    return key::f1 + static_cast<int>(*function) - 1;
  return std::nullopt;
}

}  // namespace

Result<std::vector<ScriptStep>> parse_script(std::string_view text, const std::string& file_name) {
  std::vector<ScriptStep> steps;
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string place = fmt::format("{}:{}", file_name, ++number);
    const std::string_view content = trimmed(std::string_view(line).substr(0, line.find('#')));
    if (content.empty()) continue;
    const std::string_view name = content.substr(0, content.find(' '));
    const auto command = std::ranges::find(commands, name, &Command::name);
    if (command == commands.end()) return Error{fmt::format("{}: no command '{}'", place, name)};
    steps.push_back({command->kind, std::string(trimmed(content.substr(name.size()))), place});
  }
  return steps;
}

Result<Vec2> find_place(const ScriptStep& step, const WidgetMap& widgets) {
  std::istringstream words(step.text);
  std::string first, second;
  words >> first >> second;
  const std::optional<float> x = number(first), y = number(second);
  if (x && y) return Vec2(*x, *y);
  const auto widget = widgets.find(first);
  if (widget == widgets.end())
    return Error{fmt::format("{}: no widget '{}' is on the screen", step.place, first)};
  const Rect& rect = widget->second;
  return Vec2(rect.x + y.value_or(0.5f) * rect.width, rect.y + 0.5f * rect.height);
}

Result<std::vector<InputEvent>> chord_events(const ScriptStep& step) {
  std::vector<int> codes;
  std::istringstream words(step.text);
  for (std::string name; std::getline(words, name, '+');) {
    const std::optional<int> code = key_code(name);
    if (!code) return Error{fmt::format("{}: no key '{}'", step.place, name)};
    codes.push_back(*code);
  }
  std::vector<InputEvent> events;
  for (const int code : codes) events.push_back(InputEvent::key(code, true));
  for (const int code : codes) events.push_back(InputEvent::key(code, false));
  return events;
}

}  // namespace bspview
