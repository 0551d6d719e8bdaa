#include <algorithm>
#include <span>

#include "app/viewer/work.h"

namespace bspview {
namespace {

std::uint32_t to_byte(float value) {
  // A NaN becomes 0, as in save_png.
  const float clamped = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
  return static_cast<std::uint32_t>(255.0f * clamped + 0.5f);
}

std::vector<std::uint32_t> to_rgba8(std::span<const Vec3> colors) {
  std::vector<std::uint32_t> pixels(colors.size());
  std::transform(colors.begin(), colors.end(), pixels.begin(), [](Vec3 c) {
    return 0xff000000u | to_byte(c.z) << 16 | to_byte(c.y) << 8 | to_byte(c.x);
  });
  return pixels;
}

/// Whether the pictures of both can differ in nothing but noise below the traversal's guarantee.
bool looks_alike(const PictureRequest& a, const PictureRequest& b) {
  return a.tree->request.scene == b.tree->request.scene && a.camera == b.camera &&
         a.params == b.params && a.params.traversal == Traversal::robust &&
         a.params.arithmetic == Arithmetic::exact;
}

/// The frame as an immutable picture; `before` is an earlier one of the same request, or null.
std::shared_ptr<Picture> to_picture(const Frame& frame, const Picture* before) {
  auto picture = std::make_shared<Picture>();
  picture->pass = frame.pass;
  picture->pass_count = frame.pass_count;
  picture->counts = frame.counts;
  picture->counted = frame.counted;
  // Once every pixel has its ray, later passes change the colours alone.
  if (before != nullptr && before->counted)
    picture->first_hits = before->first_hits;
  else
    picture->first_hits =
        std::make_shared<const FirstHits>(FirstHits{frame.distance, frame.object, frame.leaf});
  return picture;
}

void keep_pixels(Picture& picture, const Picture& kept) {
  picture.pixels = kept.pixels;
  picture.pixels_pass = kept.pixels_pass;
  picture.pixels_final = kept.pixels_final;
}

void set_pixels(Picture& picture, const Frame& frame) {
  picture.pixels = std::make_shared<const std::vector<std::uint32_t>>(to_rgba8(frame.color));
  picture.pixels_pass = frame.pass;
  picture.pixels_final = frame.pass == frame.pass_count;
}

}  // namespace

Result<void> PictureWork::operator()(const PictureRequest& request, std::stop_token stop,
                                     const Publish<Picture>& publish) {
  const std::shared_ptr<const Picture> kept =
      last_ && looks_alike(last_->request, request) ? last_ : nullptr;
  RenderParams params = request.params;
  const bool only_count = kept && kept->pixels_final;
  if (only_count) params.samples = 1;
  const Picture* before = nullptr;
  const ProgressiveWorlds worlds{.counted = request.tree->world(),
                                 .fast = [&] { return request.tree->fast_world(stop); },
                                 .looks_first = kept != nullptr};
  render_progressive(worlds, request.camera, params, stop, [&](const Frame& frame) {
    std::shared_ptr<Picture> picture = to_picture(frame, before);
    picture->request = request;
    if (kept && (only_count || kept->pixels_pass >= frame.pass))
      keep_pixels(*picture, *kept);
    else
      set_pixels(*picture, frame);
    last_ = picture;
    before = last_.get();
    publish(last_);
    const bool is_look = frame.pass == 0;
    if (is_look) turn_->wait_for(last_->first_hits, stop);
  });
  return {};
}

}  // namespace bspview
