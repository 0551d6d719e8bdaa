#pragma once

#include <string>

#include "app/viewer/panels/ui.h"
#include "app/viewer/results.h"

namespace bspview {

/// One line: times, speed, cost and memory, and how far the picture is.
void status_bar(const Ui& ui, const Results& results);

/// The facts on its left, separated by dots.
std::string status_text(const Results& results);

/// What is under way and how far; "" when nothing is.
std::string work_text(const Results& results);

}  // namespace bspview
