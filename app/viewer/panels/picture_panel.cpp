#include "app/viewer/panels/picture_panel.h"

#include "app/viewer/panels/scopes.h"
#include "app/viewer/panels/widgets.h"
#include "core/render/adaptive.h"

namespace bspview {
namespace {

constexpr float largest_share = 0.1f;
constexpr float least_share = 0.00005f;  // less is shown as 0

/// A slider of a share of white; 0 switches off what it is for.
void share_row(const Ui& ui, const Label& label, float& share) {
  const char* format = share > 0.0f ? "%.4f" : "off";
  if (slider_row(ui, label, share, {0.0f, largest_share, format}) && share < least_share) {
    share = 0.0f;
  }
}

DisabledScope::When unless(bool on) {
  return on ? DisabledScope::When::never : DisabledScope::When::always;
}

}  // namespace

void picture_panel(const Ui& ui, State& state) {
  if (!section(ui, "Picture", state.look.closed_sections)) return;
  const IdScope id("picture");
  PictureSettings& picture = state.picture;
  slider_row(ui,
             {"picture.samples", "Samples",
              "Rays from the eye through every pixel, once the picture has converged; with "
              "adaptive sampling, the most that a pixel gets."},
             picture.samples, {1, largest_samples, "%d a pixel", true});
  {
    const DisabledScope scope(unless(picture.samples > judged_samples));
    share_row(ui,
              {"picture.adaptive", "Adaptive",
               "Threshold t: after every 8 samples, a pixel gets no more once its error, from 0 "
               "(none) to 1 (black for white), is estimated below t in itself and its "
               "neighbours. The estimate is s/n^(3/4), s being the standard deviation of its n "
               "samples. On average the picture is off by less than t / 2. With more than 8 "
               "samples only."},
              picture.adaptive);
  }
  share_row(ui,
            {"picture.cutoff", "Cut-off",
             "Share c: reflected, refracted and shadow rays that would change the pixel by less "
             "than c are not shot. A reflected ray counts Ks of its surface times what the ray "
             "before counts, a refracted one T times. Delta counts the rays that are shot."},
            picture.cutoff);
}

}  // namespace bspview
