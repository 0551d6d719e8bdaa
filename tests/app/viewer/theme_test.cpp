#include "app/viewer/theme.h"

#include <gtest/gtest.h>

namespace bspview {
namespace {

constexpr float readable = 4.5f;  // WCAG 2.1, level AA, text

TEST(Theme, ContrastIsThatOfTheStandard) {
  EXPECT_FLOAT_EQ(contrast({1, 1, 1, 1}, {0, 0, 0, 1}), 21.0f);
  EXPECT_FLOAT_EQ(contrast({0.5f, 0.5f, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1}), 1.0f);
}

TEST(Theme, EveryTextIsReadableOnEveryGround) {
  for (const Theme theme : {Theme::dark, Theme::light}) {
    const Palette palette = palette_of(theme);
    for (const ImVec4& ground : {palette.window, palette.panel, palette.field})
      for (const ImVec4& text :
           {palette.text, palette.dim_text, palette.better, palette.worse, palette.problem})
        EXPECT_GE(contrast(text, ground), readable);
    EXPECT_GE(contrast(palette.on_accent, palette.accent), readable);
  }
}

TEST(Theme, ValuesStayReadableOnSlidersAndSelections) {
  ImGuiContext* context = ImGui::CreateContext();
  for (const Theme theme : {Theme::dark, Theme::light}) {
    apply_theme(theme, 1.0f);
    const ImVec4* colors = ImGui::GetStyle().Colors;
    for (const ImGuiCol ground :
         {ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive, ImGuiCol_FrameBgHovered,
          ImGuiCol_FrameBgActive, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive})
      EXPECT_GE(contrast(colors[ImGuiCol_Text], colors[ground]), readable)
          << ImGui::GetStyleColorName(ground);
  }
  ImGui::DestroyContext(context);
}

TEST(Theme, SizesFollowTheScale) {
  ImGuiContext* context = ImGui::CreateContext();
  apply_theme(Theme::dark, 1.0f);
  const float padding = ImGui::GetStyle().WindowPadding.x;
  apply_theme(Theme::light, 2.0f);
  EXPECT_EQ(ImGui::GetStyle().WindowPadding.x, 2 * padding);
  ImGui::DestroyContext(context);
}

}  // namespace
}  // namespace bspview
