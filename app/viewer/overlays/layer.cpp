#include "app/viewer/overlays/layer.h"

#include "app/viewer/overlays/rgba.h"
#include "core/base/check.h"

namespace bspview {

void lay_over(Layer& below, const Layer& above) {
  BSPVIEW_CHECK(below.width == above.width && below.height == above.height);
  for (std::size_t i = 0; i < below.pixels.size(); ++i) {
    if (above.pixels[i] != 0) below.pixels[i] = blend_over(above.pixels[i], below.pixels[i]);
  }
}

}  // namespace bspview
