#include "app/viewer/viewer_options.h"

#include <charconv>
#include <map>

#include "app/options/values.h"

namespace bspview {
namespace {

constexpr const char* group = "Viewer";

std::optional<Pixel> parse_pixel(const std::string& text) {
  Pixel pixel;
  const char* end = text.data() + text.size();
  const auto column = std::from_chars(text.data(), end, pixel.column);
  if (column.ec != std::errc() || column.ptr == end || *column.ptr != ',') return std::nullopt;
  const auto row = std::from_chars(column.ptr + 1, end, pixel.row);
  if (row.ec != std::errc() || row.ptr != end || pixel.column < 0 || pixel.row < 0)
    return std::nullopt;
  return pixel;
}

void add_pixel(CLI::App& app, const std::string& name, std::optional<Pixel>& pixel) {
  const auto set = [name, &pixel](const std::string& text) {
    pixel = parse_pixel(text);
    if (!pixel) throw CLI::ValidationError(name, "'" + text + "' is no pixel such as 120,80");
  };
  app.add_option_function<std::string>(name, set,
                                       "Pixel of the picture to follow, from its upper left")
      ->type_name("X,Y")
      ->group(group);
}

void add_size(CLI::App& app, ViewerOptions& options) {
  const auto set = [&options](const std::string& text) {
    const auto size = parse_picture_size(text);
    if (!size) throw CLI::ValidationError("--size", "'" + text + "' is no size such as 1280x800");
    options.width = size->width;
    options.height = size->height;
  };
  app.add_option_function<std::string>("--size", set, "Of the window or the screenshot")
      ->type_name("WxH")
      ->group(group);
}

void add_theme(CLI::App& app, ViewerOptions& options) {
  app.add_option_function<std::string>(
         "--theme",
         [&options](const std::string& name) {
           options.theme = name == "light" ? Theme::light : Theme::dark;
         },
         "Colours of the interface")
      ->check(CLI::IsMember({"dark", "light"}))
      ->type_name("dark|light")
      ->group(group);
}

CLI::Validator ends_in_png() {
  const auto check = [](const std::string& name) {
    return name.ends_with(".png") ? std::string() : "'" + name + "' does not end in .png";
  };
  return {check, ""};
}

}  // namespace

void add_viewer_options(CLI::App& app, ViewerOptions& options) {
  add_scene(app, options.tree.scene);
  app.add_option("--screenshot", options.screenshot,
                 "Save one converged frame as PNG, off-screen when there is no display, and end")
      ->type_name("FILE.png")
      ->check(ends_in_png())
      ->group(group);
  add_size(app, options);
  add_pixel(app, "--pick", options.pick);
  add_switch(app, "--panels", options.panels)->description("Show the panels")->group(group);
  add_switch(app, "--boxes", options.boxes)->description("Show the leaf boxes")->group(group);
  add_theme(app, options);
  app.add_option("--scale", options.scale, "Size of text and widgets, 0.75 to 3")
      ->check(finite_number(least_scale, largest_scale))
      ->group(group);
  app.add_option("--ui-map", options.ui_map, "Keep the rectangles of all widgets in a JSON file")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--state", options.state, "Keep what is shown in a JSON file")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--script", options.script, "Replay input from a file, off-screen, and end")
      ->type_name("FILE")
      ->group(group);
  add_arithmetic_options(app, options.arithmetic, options.offset);
  add_sampling_options(app, options.sampling, PictureSettings{}.samples);
  add_switch(app, "--check", options.check)
      ->description("Check the pixels against exact hits")
      ->group(group);
  add_tree_options(app, options.tree, "the viewer draws whole trees");
}

void apply_options(const ViewerOptions& options, State& state) {
  if (!options.tree.scene.empty()) state.source = options.tree.scene;
  state.source_text = state.source;
  state.build = options.tree.build;
  state.picture.traversal = options.tree.traversal;
  state.picture.threads = options.tree.build.threads;
  state.picture.arithmetic = options.arithmetic;
  state.picture.offset = options.offset;
  if (options.sampling.samples) state.picture.samples = *options.sampling.samples;
  state.picture.adaptive = options.sampling.adaptive;
  state.picture.cutoff = options.sampling.cutoff;
  state.pick_at_start = options.pick;
  if (options.check) state.check_pixels = *options.check;
  if (options.panels) state.panels_visible = *options.panels;
  if (options.boxes) state.boxes.visible = *options.boxes;
  if (options.theme) state.look.theme = *options.theme;
  if (options.scale) state.look.scale = *options.scale;
}

}  // namespace bspview
