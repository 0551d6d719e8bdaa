#include "app/viewer/panels/widgets.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/viewer/panels/scopes.h"

namespace bspview {
namespace {

constexpr float label_width = 96.0f;                              // design pixels
constexpr float tooltip_width = 360.0f;                           // design pixels
constexpr float subscript_scale = 0.74f, subscript_drop = 0.36f;  // of the text's size

std::string hidden_label(const Label& label) {
  return std::string("##") + label.name;
}

bool finish_row(const Ui& ui, const Label& label, bool changed) {
  ui.note(label.name);
  tooltip(ui, label.tooltip);
  return changed;
}

ImGuiSliderFlags slider_flags(bool logarithmic) {
  return ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
}

}  // namespace

void Ui::note(const std::string& name) const {
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  widgets[name] = {lo.x, lo.y, hi.x - lo.x, hi.y - lo.y};
}

bool section(const Ui& ui, const char* title, std::set<std::string>& closed) {
  ImGui::Dummy({0.0f, ui.px(1)});
  ImGui::SetNextItemOpen(!closed.contains(title));
  bool open = false;
  {
    const FontScope bold(ui.fonts.bold);
    const ColorScope background(ImGuiCol_Header, ui.palette.panel);
    open = ImGui::CollapsingHeader(title);
  }
  ui.note(std::string("section.") + title);
  if (open)
    closed.erase(title);
  else
    closed.insert(title);
  return open;
}

void begin_row(const Ui& ui, const Label& label) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label.text);
  tooltip(ui, label.tooltip);
  ImGui::SameLine(ui.px(label_width) + ImGui::GetStyle().WindowPadding.x);
  ImGui::SetNextItemWidth(-1.0f);
}

bool combo_row(const Ui& ui, const Label& label, std::span<const std::string_view> names,
               int& index) {
  begin_row(ui, label);
  std::string items;
  for (const std::string_view name : names) (items += name) += '\0';
  const bool changed = ImGui::Combo(hidden_label(label).c_str(), &index, items.c_str(), 20);
  return finish_row(ui, label, changed);
}

bool slider_row(const Ui& ui, const Label& label, int& value, const Range<int>& range) {
  begin_row(ui, label);
  const bool changed = ImGui::SliderInt(hidden_label(label).c_str(), &value, range.lo, range.hi,
                                        range.format, slider_flags(range.logarithmic));
  return finish_row(ui, label, changed);
}

bool slider_row(const Ui& ui, const Label& label, float& value, const Range<float>& range) {
  begin_row(ui, label);
  const bool changed = ImGui::SliderFloat(hidden_label(label).c_str(), &value, range.lo, range.hi,
                                          range.format, slider_flags(range.logarithmic));
  return finish_row(ui, label, changed);
}

bool check_row(const Ui& ui, const Label& label, bool& value) {
  const IdScope id(label.name);
  return finish_row(ui, label, ImGui::Checkbox(label.text, &value));
}

bool button(const Ui& ui, const Label& label) {
  const IdScope id(label.name);
  return finish_row(ui, label, ImGui::Button(label.text));
}

void tooltip(const Ui& ui, std::string_view text) {
  if (text.empty() || !ui.tooltips || ImGui::IsAnyItemActive()) return;
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const StyleScope padding(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(8), ui.px(6)));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ui.px(tooltip_width));
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void dim_text(const Ui& ui, std::string_view text) {
  const ColorScope color(ImGuiCol_Text, ui.palette.dim_text);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void wrapped_text(const Ui&, std::string_view text, const ImVec4& color) {
  const ColorScope text_color(ImGuiCol_Text, color);
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
}

void right_aligned(std::string_view text) {
  const float width = ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
  const float gap = ImGui::GetContentRegionAvail().x - width;
  if (gap > 0.0f) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + gap);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void symbols(const Ui& ui, std::string_view text) {
  const float size = ImGui::GetFontSize(), small = std::round(size * subscript_scale);
  const float drop = std::round(subscript_drop * size);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
  float x = at.x;
  const auto draw = [&](std::string_view part, float font_size, float y) {
    const char* begin = part.data();
    const char* end = begin + part.size();
    ImGui::GetWindowDrawList()->AddText(ui.fonts.text, font_size, {x, y}, color, begin, end);
    x += ui.fonts.text->CalcTextSizeA(font_size, 1e9f, 0.0f, begin, end).x;
  };
  while (!text.empty()) {
    const std::size_t mark = std::min(text.find('_'), text.size());
    draw(text.substr(0, mark), size, at.y);
    text.remove_prefix(std::min(mark + 1, text.size()));
    if (mark == 0 && text.empty()) break;
    const std::size_t end = std::min(text.find(' '), text.size());
    draw(text.substr(0, end), small, at.y + drop);
    text.remove_prefix(end);
  }
  ImGui::Dummy({x - at.x, ImGui::GetTextLineHeight()});
}

}  // namespace bspview
