#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>

#include "app/viewer/panels/ui.h"

namespace bspview {

/// What a row with a widget says of itself. The name is the one in the WidgetMap.
struct Label {
  const char* name;
  const char* text;
  const char* tooltip;
};

/// Range of a slider; values outside cannot be typed either.
template <class T>
struct Range {
  T lo, hi;
  const char* format;
  bool logarithmic = false;
};

/// A heading that folds what is below it; true when unfolded.
bool section(const Ui& ui, const char* title, std::set<std::string>& closed);

// Rows: the label on the left, the widget over the rest of the width. True when the value changed.
bool combo_row(const Ui& ui, const Label& label, std::span<const std::string_view> names,
               int& index);
bool slider_row(const Ui& ui, const Label& label, int& value, const Range<int>& range);
bool slider_row(const Ui& ui, const Label& label, float& value, const Range<float>& range);
bool check_row(const Ui& ui, const Label& label, bool& value);

/// Puts the next widget where those of the rows are.
void begin_row(const Ui& ui, const Label& label);

/// A button as wide as its text; takes itself down as `label.name`.
bool button(const Ui& ui, const Label& label);

/// The last item explains itself when the pointer rests on it.
void tooltip(const Ui& ui, std::string_view text);

void dim_text(const Ui& ui, std::string_view text);
void wrapped_text(const Ui& ui, std::string_view text, const ImVec4& color);
void right_aligned(std::string_view text);

/// Mathematics: what follows an underscore, up to a space, is a subscript.
void symbols(const Ui& ui, std::string_view text);

}  // namespace bspview
