#pragma once

#include <string>

#include "app/viewer/app.h"

namespace bspview {

/// What is on show, as one JSON object: for scripts and tests that watch the program from outside.
std::string export_state(const App& app);

/// Name of every widget of the last frame -> [x, y, width, height] in window coordinates.
std::string export_widgets(const WidgetMap& widgets);

/// Keeps a file up to date with a text that changes now and then.
class ExportedFile {
 public:
  /// "": none.
  explicit ExportedFile(std::string file) : file_(std::move(file)) {}
  bool wanted() const { return !file_.empty(); }
  /// Writes when `text` is another than the last time.
  Result<void> update(std::string text);

 private:
  std::string file_, text_;
};

}  // namespace bspview
