#pragma once

#include <imgui.h>

#include "app/viewer/layout.h"

namespace bspview {

// Every Begin has its End, whatever path a panel takes.

inline constexpr ImGuiWindowFlags unscrolled =
    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
/// Regions stay below what lies over them: splitters, help, menus.
inline constexpr ImGuiWindowFlags below = ImGuiWindowFlags_NoBringToFrontOnFocus;

/// A window that fills one region of the layout and cannot be moved.
class RegionScope {
 public:
  RegionScope(const char* name, const Rect& rect, ImGuiWindowFlags more_flags = below);
  ~RegionScope();
  RegionScope(const RegionScope&) = delete;
  RegionScope& operator=(const RegionScope&) = delete;
};

class ColorScope {
 public:
  ColorScope(ImGuiCol index, const ImVec4& color) { ImGui::PushStyleColor(index, color); }
  ~ColorScope() { ImGui::PopStyleColor(); }
  ColorScope(const ColorScope&) = delete;
  ColorScope& operator=(const ColorScope&) = delete;
};

template <class Value>
class StyleScope {
 public:
  StyleScope(ImGuiStyleVar index, Value value) { ImGui::PushStyleVar(index, value); }
  ~StyleScope() { ImGui::PopStyleVar(); }
  StyleScope(const StyleScope&) = delete;
  StyleScope& operator=(const StyleScope&) = delete;
};

class FontScope {
 public:
  explicit FontScope(ImFont* font) { ImGui::PushFont(font); }
  ~FontScope() { ImGui::PopFont(); }
  FontScope(const FontScope&) = delete;
  FontScope& operator=(const FontScope&) = delete;
};

class IdScope {
 public:
  explicit IdScope(const char* id) { ImGui::PushID(id); }
  explicit IdScope(int id) { ImGui::PushID(id); }
  ~IdScope() { ImGui::PopID(); }
  IdScope(const IdScope&) = delete;
  IdScope& operator=(const IdScope&) = delete;
};

class DisabledScope {
 public:
  enum class When { never, always };
  explicit DisabledScope(When when) { ImGui::BeginDisabled(when == When::always); }
  ~DisabledScope() { ImGui::EndDisabled(); }
  DisabledScope(const DisabledScope&) = delete;
  DisabledScope& operator=(const DisabledScope&) = delete;
};

/// A table; convertible to false when it is out of sight and must not be filled.
class TableScope {
 public:
  TableScope(const char* name, int columns, ImGuiTableFlags flags, const ImVec2& size = {})
      : open_(ImGui::BeginTable(name, columns, flags, size)) {}
  ~TableScope() {
    if (open_) ImGui::EndTable();
  }
  TableScope(const TableScope&) = delete;
  TableScope& operator=(const TableScope&) = delete;
  explicit operator bool() const { return open_; }

 private:
  bool open_;
};

}  // namespace bspview
