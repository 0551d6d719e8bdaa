#include "app/viewer/theme.h"

#include <algorithm>
#include <cmath>

namespace bspview {
namespace {

ImVec4 rgb(std::uint32_t hex) {
  return ImGui::ColorConvertU32ToFloat4(
      IM_COL32((hex >> 16) & 0xff, (hex >> 8) & 0xff, hex & 0xff, 0xff));
}

ImVec4 mix(const ImVec4& a, const ImVec4& b, float share) {
  const auto blend = [share](float x, float y) { return x + share * (y - x); };
  return {blend(a.x, b.x), blend(a.y, b.y), blend(a.z, b.z), 1.0f};
}

ImVec4 fade(ImVec4 color, float alpha) {
  color.w = alpha;
  return color;
}

// WCAG 2.1, "relative luminance".
float luminance(const ImVec4& color) {
  const auto linear = [](float c) {
    return c <= 0.03928f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
  };
  return 0.2126f * linear(color.x) + 0.7152f * linear(color.y) + 0.0722f * linear(color.z);
}

void set_surface_colors(ImVec4* colors, const Palette& p) {
  colors[ImGuiCol_Text] = p.text;
  colors[ImGuiCol_TextDisabled] = p.dim_text;
  colors[ImGuiCol_WindowBg] = p.panel;
  colors[ImGuiCol_ChildBg] = fade(p.panel, 0.0f);
  colors[ImGuiCol_PopupBg] = p.panel;
  colors[ImGuiCol_Border] = p.line;
  colors[ImGuiCol_BorderShadow] = fade(p.line, 0.0f);
  colors[ImGuiCol_MenuBarBg] = p.window;
  colors[ImGuiCol_ScrollbarBg] = fade(p.panel, 0.0f);
  colors[ImGuiCol_ScrollbarGrab] = p.line;
  colors[ImGuiCol_ScrollbarGrabHovered] = mix(p.line, p.text, 0.2f);
  colors[ImGuiCol_ScrollbarGrabActive] = mix(p.line, p.text, 0.4f);
  colors[ImGuiCol_Separator] = p.line;
  colors[ImGuiCol_TableHeaderBg] = fade(p.field, 0.0f);
  colors[ImGuiCol_TableBorderStrong] = p.line;
  colors[ImGuiCol_TableBorderLight] = p.line;
  colors[ImGuiCol_TableRowBg] = fade(p.panel, 0.0f);
  colors[ImGuiCol_TableRowBgAlt] = fade(p.field, 0.5f);
  colors[ImGuiCol_ModalWindowDimBg] = fade(p.window, 0.5f);
}

void set_widget_colors(ImVec4* colors, const Palette& p) {
  colors[ImGuiCol_FrameBg] = p.field;
  colors[ImGuiCol_FrameBgHovered] = mix(p.field, p.accent, 0.12f);
  colors[ImGuiCol_FrameBgActive] = mix(p.field, p.accent, 0.2f);
  colors[ImGuiCol_CheckMark] = p.accent;
  colors[ImGuiCol_SliderGrab] = mix(p.field, p.accent, 0.6f);  // values stay readable on it
  colors[ImGuiCol_SliderGrabActive] = mix(p.field, p.accent, 0.8f);
  colors[ImGuiCol_Button] = p.field;
  colors[ImGuiCol_ButtonHovered] = mix(p.field, p.accent, 0.25f);
  colors[ImGuiCol_ButtonActive] = mix(p.field, p.accent, 0.45f);
  colors[ImGuiCol_Header] = mix(p.panel, p.accent, 0.22f);
  colors[ImGuiCol_HeaderHovered] = mix(p.panel, p.accent, 0.16f);
  colors[ImGuiCol_HeaderActive] = mix(p.panel, p.accent, 0.3f);
  colors[ImGuiCol_SeparatorHovered] = p.accent;
  colors[ImGuiCol_SeparatorActive] = p.accent;
  colors[ImGuiCol_TextSelectedBg] = fade(p.accent, 0.35f);
  colors[ImGuiCol_PlotHistogram] = p.accent;
}

void set_sizes(ImGuiStyle& style) {
  style.WindowPadding = {10.0f, 6.0f};
  style.FramePadding = {6.0f, 2.0f};
  style.ItemSpacing = {6.0f, 4.0f};
  style.ItemInnerSpacing = {6.0f, 4.0f};
  style.CellPadding = {4.0f, 1.5f};
  style.IndentSpacing = 14.0f;
  style.ScrollbarSize = 10.0f;
  style.GrabMinSize = 8.0f;
  style.WindowRounding = 0.0f;
  style.WindowBorderSize = 0.0f;
  style.ChildRounding = style.FrameRounding = style.GrabRounding = 3.0f;
  style.PopupRounding = 4.0f;
  style.PopupBorderSize = 1.0f;
  style.FrameBorderSize = 0.0f;
  style.ScrollbarRounding = 5.0f;
}

}  // namespace

Palette palette_of(Theme theme) {
  if (theme == Theme::dark)
    return {.window = rgb(0x14161a),
            .panel = rgb(0x1d2025),
            .field = rgb(0x2a2e35),
            .line = rgb(0x3a3f48),
            .text = rgb(0xe4e7eb),
            .dim_text = rgb(0xa2aab5),
            .accent = rgb(0x5aa7ee),
            .on_accent = rgb(0x0d1420),
            .better = rgb(0x62c58b),
            .worse = rgb(0xf0a35e),
            .problem = rgb(0xff8f85)};
  return {.window = rgb(0xe3e6ea),
          .panel = rgb(0xf7f8fa),
          .field = rgb(0xe7eaee),
          .line = rgb(0xc9ced6),
          .text = rgb(0x1c2127),
          .dim_text = rgb(0x555d68),
          .accent = rgb(0x1f6fc0),
          .on_accent = rgb(0xffffff),
          .better = rgb(0x14693a),
          .worse = rgb(0x8f4a00),
          .problem = rgb(0xb3261e)};
}

void apply_theme(Theme theme, float scale) {
  ImGuiStyle style;
  set_sizes(style);
  style.ScaleAllSizes(scale);
  const Palette palette = palette_of(theme);
  set_surface_colors(style.Colors, palette);
  set_widget_colors(style.Colors, palette);
  ImGui::GetStyle() = style;
}

float contrast(const ImVec4& a, const ImVec4& b) {
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05f) / (dark + 0.05f);
}

}  // namespace bspview
