#include "app/viewer/app.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/viewer/panels/panels.h"
#include "core/render/adaptive.h"

namespace bspview {
namespace {

using namespace std::chrono_literals;

// See Stage::Patience. Trees of a hundred thousand objects, or their sketches, follow a slider that
// never rests; coarse pixels and lines are soon there and keep a moving camera alive.
constexpr auto build_patience = 100ms;
constexpr auto drawing_patience = 300ms;
constexpr auto rest_after = 150ms;     // without motion of the camera
constexpr int frames_to_focus = 2;     // until a text field that was asked to has the keyboard
constexpr auto tooltip_after = 400ms;  // without motion of the pointer
constexpr auto progress_every = 200ms;

}  // namespace

App::App(State state, std::function<void()> wake)
    : state_(std::move(state)),
      history_(setting()),
      last_setting_(setting()),
      scenes_(open_scene, wake),
      trees_(tree_work_, wake,
             {build_patience, [this](const TreeRequest& wish) { return tree_work_.serves(wish); }}),
      pictures_(PictureWork(overlay_turn_), wake, {drawing_patience}),
      paths_(follow_rays, wake, {drawing_patience}),
      overlays_(OverlayWork(overlay_turn_), wake, {drawing_patience}),
      accuracy_(judge_picture, wake),
      measures_(take_times, wake) {}

void App::frame(Interface& interface, const WindowSize& size) {
  advance();
  widgets_.clear();
  watch_pointer();
  ui_scale_ = interface.scale();
  const Ui ui{interface.fonts(), interface.palette(), interface.scale(), !tooltips_due_, widgets_};
  const Vec2 window(static_cast<float>(size.width), static_cast<float>(size.height));
  for (const Action action : pressed_actions(ImGui::GetIO())) perform(action);
  if (state_.focus_source) interface.input().hold(frames_to_focus);
  std::vector<Action> chosen;
  draw_panels(ui, window, results_, state_, chosen);
  for (const Action action : chosen) perform(action);
  view_ = layout_for(ui, window, state_).view;
  const float pixels_per_unit = static_cast<float>(size.pixel_width) / window.x;
  state_.view.size = {std::max(1, static_cast<int>(std::lround(view_.width * pixels_per_unit))),
                      std::max(1, static_cast<int>(std::lround(view_.height * pixels_per_unit)))};
  watch_camera();
  watch_edits();
  advance();
  progress_shown_ = Clock::now();
}

void App::perform(Action action) {
  const std::size_t objects = results_.scene ? results_.scene->counts.objects : 0;
  if (change_state(action, state_, objects)) return;
  switch (action) {
    case Action::undo:
      return restore(history_.undo());
    case Action::redo:
      return restore(history_.redo());
    case Action::frame:
      if (state_.view.camera) state_.view.camera->frame(state_.view.size);
      return;
    case Action::reset:
      if (state_.view.camera) state_.view.camera->reset();
      return;
    case Action::quit:
      quit_ = true;
      return;
    case Action::full_screen:
      full_screen_ = true;
      return;
    case Action::screenshot:
      screenshot_ = true;
      return;
    default:
      return;
  }
}

void App::open(const std::string& source) {
  open_source(state_, source);
}

bool App::busy() const {
  return scenes_.busy() || trees_.busy() || pictures_.busy() || paths_.busy() || overlays_.busy() ||
         accuracy_.busy() || measures_.busy();
}

std::optional<double> App::next_frame_in() const {
  std::optional<double> soonest;
  const auto due = [&soonest](Clock::duration in) {
    const double seconds = std::max(0.0, std::chrono::duration<double>(in).count());
    soonest = std::min(seconds, soonest.value_or(seconds));
  };
  const Clock::time_point now = Clock::now();
  if (was_moving_) due(last_motion_ + rest_after - now);
  if (tooltips_due_) due(pointer_moved_ + tooltip_after - now);
  if (trees_.busy()) due(progress_shown_ + progress_every - now);
  for (const auto& drop :
       {trees_.drop_due(), pictures_.drop_due(), paths_.drop_due(), overlays_.drop_due()})
    if (drop) due(*drop - now);
  return soonest;
}

/// Why is it recomputing: here.
void App::advance() {
  was_moving_ = moving();
  scenes_.want(SceneRequest{state_.source, state_.load_attempt});
  want_tree();
  watch_scene();
  want_picture();
  if (trees_.value() && state_.pick)
    paths_.want(PathRequest{trees_.value(), render_params(1), *state_.pick});
  else
    paths_.want(std::nullopt);
  want_accuracy();
  want_overlay();
  want_measures();
  show_results();
}

void App::want_tree() {
  if (scenes_.value())
    trees_.want(TreeRequest{scenes_.value(), state_.build});
  else
    trees_.want(std::nullopt);
}

void App::want_picture() {
  if (trees_.value() && state_.view.camera && state_.view.size.width > 1)
    pictures_.want(PictureRequest{trees_.value(), state_.view.camera->camera(),
                                  render_params(state_.picture.samples)});
  else
    pictures_.want(std::nullopt);
}

void App::want_overlay() {
  const std::shared_ptr<const Picture>& picture = pictures_.value();
  // The picture may still be of the tree before: node numbers of one tree mean nothing in another.
  std::shared_ptr<const PixelRays> rays = paths_.value();
  if (rays && picture && rays->request.tree != picture->request.tree) rays = nullptr;
  const bool path = state_.path_visible && rays;
  const std::shared_ptr<const Accuracy>& accuracy = accuracy_.value();
  const bool is_wanted = picture && (state_.boxes.visible || path || accuracy);
  overlay_turn_->expect(is_wanted);
  if (!is_wanted) return overlays_.want(std::nullopt);
  const RenderParams& params = picture->request.params;
  OverlayRequest request{.tree = picture->request.tree,
                         .first_hits = picture->first_hits,
                         .camera = picture->request.camera,
                         .width = params.width,
                         .height = params.height,
                         .boxes = std::nullopt,
                         .rays = rays,
                         .accuracy = accuracy,
                         .path_visible = path,
                         .selection = state_.ray,
                         .line_width = ui_scale_,
                         .moving = was_moving_};
  if (state_.boxes.visible) request.boxes = state_.boxes;
  // Coarse pixels have no borders worth drawing.
  if (request.boxes) request.boxes->borders &= picture->counted;
  if (state_.hovered_step) request.selection.step = *state_.hovered_step;
  overlays_.want(request);
}

bool App::at_rest() const {
  return pictures_.value() && !pictures_.busy() && !trees_.busy() && !was_moving_;
}

void App::want_accuracy() {
  const std::shared_ptr<const Picture>& picture = pictures_.value();
  if (at_rest() && state_.check_pixels)
    accuracy_.want(
        AccuracyRequest{picture->request.tree, picture->request.camera, render_params(1)});
  else
    accuracy_.want(std::nullopt);
}

/// Two measurements at once would disturb each other.
void App::want_measures() {
  const std::shared_ptr<const Picture>& picture = pictures_.value();
  if (at_rest() && state_.measure_times && !accuracy_.busy())
    measures_.want(
        MeasureRequest{picture->request.tree, picture->request.camera, render_params(1)});
  else
    measures_.want(std::nullopt);
}

void App::show_results() {
  results_.scene = scenes_.value();
  if (scenes_.error() && scenes_.error() != results_.scene_error)
    state_.notice = scenes_.error()->message;
  results_.scene_error = scenes_.error();
  results_.scene_busy = scenes_.busy();
  results_.tree = trees_.value();
  results_.tree_error = trees_.error();
  results_.tree_busy = trees_.busy();
  results_.tree_progress = tree_work_.progress();
  results_.picture = pictures_.value();
  results_.picture_busy = pictures_.busy();
  results_.rays = paths_.value();
  results_.overlay = overlays_.value();
  results_.accuracy = accuracy_.value();
  results_.accuracy_busy = accuracy_.busy();
  results_.measures_busy = measures_.busy();
  if (results_.tree)
    comparison_.update(evaluate(*results_.tree, results_.picture.get(), measures_.value().get()));
  results_.now = comparison_.now();
  results_.before = comparison_.before();
}

/// A new scene is seen as its file says, once its tree is there.
void App::watch_scene() {
  if (!trees_.value() || trees_.value()->request.scene == camera_scene_) return;
  camera_scene_ = trees_.value()->request.scene;
  const PictureSize size = state_.view.size;
  state_.view = View();
  state_.view.camera = OrbitCamera(camera_scene_->scene.camera, camera_scene_->bounds);
  state_.view.size = size;
  state_.pick.reset();
  state_.ray = {};
  if (state_.pick_at_start) pick_at_start(*std::exchange(state_.pick_at_start, std::nullopt));
}

void App::pick_at_start(Pixel pixel) {
  const PictureSize size = state_.view.size;
  pixel.column = std::min(pixel.column, size.width - 1);
  pixel.row = std::min(pixel.row, size.height - 1);
  state_.pick = Pick{pixel, state_.view.camera->camera(), size.width, size.height};
}

void App::watch_camera() {
  const std::optional<Camera> camera =
      state_.view.camera ? std::optional(state_.view.camera->camera()) : std::nullopt;
  if (camera && last_camera_ && *camera != *last_camera_) last_motion_ = Clock::now();
  last_camera_ = camera;
}

/// An edit lasts for as long as its widget is held.
void App::watch_edits() {
  if (setting() != last_setting_ && !editing_) {
    if (!setting().measures_as(last_setting_)) comparison_.begin_edit();
    editing_ = true;
  }
  last_setting_ = setting();
  if (ImGui::IsAnyItemActive()) return;
  editing_ = false;
  history_.commit(setting());
}

/// Tooltips wait for the pointer to rest.
void App::watch_pointer() {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f) pointer_moved_ = Clock::now();
  tooltips_due_ = !io.MouseDown[0] && Clock::now() - pointer_moved_ < tooltip_after;
}

bool App::moving() const {
  return Clock::now() - last_motion_ < rest_after;
}

void App::restore(const Setting& setting) {
  state_.build = setting.build;
  state_.picture = setting.picture;
}

RenderParams App::render_params(int samples) const {
  return {.width = state_.view.size.width,
          .height = state_.view.size.height,
          .samples = samples,
          .max_ray_depth = state_.picture.max_ray_depth,
          .spd_rules = false,
          .traversal = state_.picture.traversal,
          .arithmetic = state_.picture.arithmetic,
          .offset = state_.picture.offset,
          .threads = state_.picture.threads,
          .cutoff = state_.picture.cutoff,
          .adaptive = samples > judged_samples ? state_.picture.adaptive : 0.0f};
}

}  // namespace bspview
