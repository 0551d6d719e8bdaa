#pragma once

#include <optional>
#include <set>
#include <string>

#include "app/viewer/layout.h"
#include "app/viewer/orbit_camera.h"
#include "app/viewer/overlays/node_boxes.h"
#include "app/viewer/overlays/ray_path.h"
#include "app/viewer/picking.h"
#include "app/viewer/theme.h"
#include "core/bsp/traversal.h"
#include "core/bsp/tree.h"
#include "core/render/arithmetic.h"
#include "core/scene/camera.h"

namespace bspview {

/// Which leaf boxes are drawn, and how.
struct BoxView {
  enum class Cells { touched, all };  ///< touched: by the visible surface and the picked rays

  bool visible = false;
  Cells cells = Cells::touched;
  LeafFilter filter;
  LeafColor color_by = LeafColor::objects;
  ColorMap map = ColorMap::viridis;
  bool borders = true;  ///< of the cells on the visible surfaces
  bool operator==(const BoxView&) const = default;
};

/// A pixel that was clicked, with the view in which it was: the ray stays where it is in the scene
/// when the camera moves on.
struct Pick {
  Pixel pixel;
  Camera camera;
  int width = 0, height = 0;  ///< of the picture
  bool operator==(const Pick&) const = default;
};

/// Where the scene is seen from, and the mouse's way over the picture.
struct View {
  std::optional<OrbitCamera> camera;  ///< none without a scene
  PictureSize size;
  PressTracker press;            ///< of the left button
  std::optional<Vec2> pan_from;  ///< pixel coordinates, while moving sideways
  float pan_depth = 0.0f;
};

/// How the picture is made.
struct PictureSettings {
  Traversal traversal = Traversal::robust;
  Arithmetic arithmetic = Arithmetic::exact;
  OffsetRule offset = OffsetRule::error_bounded;
  int samples = 4;  ///< a pixel, when converged; with adaptive sampling the most
  float adaptive = 0.0f, cutoff = 0.0f;  ///< 0: off; see RenderParams
  int max_ray_depth = 5;
  int threads = 0;
  bool operator==(const PictureSettings&) const = default;
};

inline constexpr int largest_samples = 1024;

/// Appearance of the window; kept from one run to the next.
struct Look {
  Theme theme = Theme::dark;
  float scale = 1.0f;  ///< of text and widgets, times the display's
  Splits splits;
  std::set<std::string> closed_sections;
  bool operator==(const Look&) const = default;
};
inline constexpr float least_scale = 0.75f, largest_scale = 3.0f;

/// Everything that the user decides.
struct State {
  std::string source = "spd:balls";  ///< as load_scene understands it
  int load_attempt = 0;              ///< a change loads `source` once more
  BuildParams build;
  PictureSettings picture;
  bool measure_times = true;  ///< T_TR and T_TT when nothing moves
  bool check_pixels =
      false;  ///< against exact hits, when nothing moves; and run time against error
  View view;
  std::optional<Pick> pick;
  std::optional<Pixel> pick_at_start;  ///< becomes the pick of the first view of a scene
  RaySelection ray;
  std::optional<int> hovered_step;  ///< of the selected ray; for one frame
  bool path_visible = true;
  BoxView boxes;
  Look look;
  bool panels_visible = true;
  bool help_visible = false;
  std::string source_text = source;  ///< what is being typed into the scene field
  bool focus_source = false;         ///< put the cursor there in the next frame
  std::string notice;                ///< a sentence for the user, until something is done
};

/// Asks for a scene, once more when it is the one that is shown.
void open_source(State& state, const std::string& source);

}  // namespace bspview
