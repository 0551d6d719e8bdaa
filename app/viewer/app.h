#pragma once

#include <chrono>
#include <functional>
#include <utility>
#include <vector>

#include "app/viewer/actions.h"
#include "app/viewer/evaluation.h"
#include "app/viewer/history.h"
#include "app/viewer/interface.h"
#include "app/viewer/results.h"
#include "app/viewer/stage.h"
#include "app/viewer/state.h"
#include "app/viewer/widget_map.h"
#include "app/viewer/work.h"

namespace bspview {

/// The viewer without its window: what the user wants, the stages that get it, and the frame that
/// shows both. All of it belongs to one thread, the interface's.
class App {
 public:
  /// `wake` is called from other threads whenever there is something new to show.
  App(State state, std::function<void()> wake);

  /// One frame: takes the input in, draws the panels, asks the stages for what is then wanted.
  void frame(Interface& interface, const WindowSize& size);

  void perform(Action action);
  /// Opens a scene, as a dropped file does.
  void open(const std::string& source);

  const State& state() const { return state_; }
  State& state() { return state_; }
  const Results& results() const { return results_; }
  const WidgetMap& widgets() const { return widgets_; }
  const Rect& view() const { return view_; }

  /// Something is being computed.
  bool busy() const;
  /// Seconds until a frame is due without any event; nullopt: none is.
  std::optional<double> next_frame_in() const;

  bool take_quit() { return std::exchange(quit_, false); }
  bool take_full_screen() { return std::exchange(full_screen_, false); }
  bool take_screenshot() { return std::exchange(screenshot_, false); }

 private:
  using Clock = std::chrono::steady_clock;

  /// What undo takes back.
  struct Setting {
    BuildParams build;
    PictureSettings picture;
    bool operator==(const Setting&) const = default;
    /// Whether Delta and Lambda are the same for both: they are those of one ray a pixel.
    bool measures_as(Setting other) const {
      other.picture.samples = picture.samples;
      other.picture.adaptive = picture.adaptive;
      return *this == other;
    }
  };

  void advance();
  void want_tree();
  void want_picture();
  void want_overlay();
  void want_accuracy();
  void want_measures();
  void show_results();
  void watch_scene();
  void pick_at_start(Pixel pixel);
  void watch_camera();
  void watch_edits();
  bool moving() const;
  bool at_rest() const;
  void watch_pointer();
  Setting setting() const { return {state_.build, state_.picture}; }
  void restore(const Setting& setting);
  RenderParams render_params(int samples) const;

  State state_;
  Results results_;
  WidgetMap widgets_;
  Rect view_;
  Comparison comparison_;
  History<Setting> history_;
  Setting last_setting_;
  bool editing_ = false;
  float ui_scale_ = 1.0f;
  std::shared_ptr<const LoadedScene> camera_scene_;  // the scene that state_.view.camera is for
  std::optional<Camera> last_camera_;
  Clock::time_point last_motion_;     // of the camera
  Clock::time_point pointer_moved_;   // last
  Clock::time_point progress_shown_;  // last
  bool was_moving_ = false, tooltips_due_ = false;
  bool quit_ = false, full_screen_ = false, screenshot_ = false;

  Stage<SceneRequest, LoadedScene> scenes_;
  TreeWork tree_work_;
  Stage<TreeRequest, BuiltTree> trees_;
  const std::shared_ptr<OverlayTurn> overlay_turn_ = std::make_shared<OverlayTurn>();
  Stage<PictureRequest, Picture> pictures_;
  Stage<PathRequest, PixelRays> paths_;
  Stage<OverlayRequest, Overlay> overlays_;
  Stage<AccuracyRequest, Accuracy> accuracy_;
  Stage<MeasureRequest, Measures> measures_;
};

}  // namespace bspview
