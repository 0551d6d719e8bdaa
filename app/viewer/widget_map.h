#pragma once

#include <map>
#include <string>

#include "app/viewer/layout.h"

namespace bspview {

/// Where on the screen each named widget is in this frame: for scripts and tests.
using WidgetMap = std::map<std::string, Rect>;

}  // namespace bspview
