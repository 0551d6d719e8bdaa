// Adaptive sampling and the cut-off, by their pictures.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/eval/image_error.h"
#include "core/render/record.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"
#include "tests/support/scenes.h"

namespace bspview {
namespace {

/// A scene with its tree.
struct Built {
  explicit Built(Scene of) : scene(std::move(of)), tree(*build_scene_tree(scene, {})) {}
  Built(const char* spd, int size) : Built(*make_spd(spd, size)) {}
  World world() const { return {scene, tree}; }
  Scene scene;
  Tree tree;
};

RenderParams small_picture(int samples, float adaptive) {
  RenderParams params;
  params.width = 70;  // not a multiple of the tile
  params.height = 50;
  params.samples = samples;
  params.adaptive = adaptive;
  return params;
}

CountedImage picture(const Built& built, const RenderParams& params) {
  auto made = render_counted(built.world(), built.scene.camera, params);
  EXPECT_TRUE(made.ok());
  return std::move(*made);
}

TEST(AdaptivePicture, DoesNotDependOnTheNumberOfThreads) {
  const Built built(test::random_scene(300, 61));
  RenderParams params = small_picture(40, 0.01f);
  params.threads = 1;
  const CountedImage one = picture(built, params);
  for (const int threads : {2, 3, 8}) {
    params.threads = threads;
    const CountedImage many = picture(built, params);
    EXPECT_EQ(many.image, one.image) << threads;
    EXPECT_EQ(many.counts, one.counts) << threads;
  }
}

TEST(AdaptivePicture, IsTheSameCountedRecordedAndProgressive) {
  const Built built(test::random_scene(200, 62));
  const RenderParams params = small_picture(29, 0.02f);  // ends between two judgements
  const CountedImage counted = picture(built, params);
  EXPECT_EQ(*render_image(built.world(), built.scene.camera, params), counted.image);
  EXPECT_EQ(record_rays(built.world(), built.scene.camera, params)->size(), counted.counts.all());
  Frame last;
  render_progressive(built.world(), built.scene.camera, params, {},
                     [&](const Frame& frame) { last = frame; });
  EXPECT_EQ(last.color, counted.image.pixels);
  EXPECT_EQ(last.pass, last.pass_count);
}

TEST(AdaptivePicture, ConvergesEarlyWhereNoPixelNeedsMore) {
  const Built built(test::cube_grid(2, Vec3(0.0f)));
  RenderParams params = small_picture(64, 0.99f);
  std::vector<std::pair<int, int>> passes;
  render_progressive(built.world(), built.scene.camera, params, {}, [&](const Frame& frame) {
    passes.emplace_back(frame.pass, frame.pass_count);
  });
  ASSERT_EQ(passes.size(), 11u);  // 4 to the first sample, 7 more samples
  EXPECT_EQ(passes[9], std::pair(10, 67));
  EXPECT_EQ(passes[10], std::pair(11, 11));
  params.samples = 8;
  EXPECT_EQ(picture(built, small_picture(64, 0.99f)).image, picture(built, params).image);
}

TEST(AdaptivePicture, ProgressAddsUpToOne) {
  const Built built(test::random_scene(50, 63));
  for (const float threshold : {0.0f, 0.9f, 0.01f, 1e-9f}) {
    RenderParams params = small_picture(20, threshold);
    params.threads = 1;
    double done = 0.0;
    Watch watch;
    watch.progress = [&](double more) { done += more; };
    ASSERT_TRUE(render_image(built.world(), built.scene.camera, params, watch).ok());
    EXPECT_NEAR(done, 1.0, 1e-9) << threshold;
  }
}

TEST(AdaptivePicture, FewerSamplesThanEightAreTakenEverywhere) {
  const Built built(test::random_scene(100, 64));
  EXPECT_EQ(picture(built, small_picture(7, 0.9f)).image,
            picture(built, small_picture(7, 0.0f)).image);
}

TEST(AdaptivePicture, TheSpdRulesKnowNoThreshold) {
  const Built built("balls", 1);
  RenderParams params = small_picture(64, 0.5f);
  params.spd_rules = true;
  const CountedImage adaptive = picture(built, params);
  params.adaptive = 0.0f;
  EXPECT_EQ(picture(built, params).image, adaptive.image);
}

class AdaptiveBias : public testing::TestWithParam<SpdScene> {};

TEST_P(AdaptiveBias, IsWellBelowTheThreshold) {
  const SpdScene& spd = GetParam();
  const int size = std::max(1, spd.standard_size / 2);
  const Built built(*make_spd(spd.name, spd.has_size ? std::optional(size) : std::nullopt));
  RenderParams params = small_picture(64, 0.0f);
  params.width = params.height = 32;
  const CountedImage uniform = picture(built, params);
  for (const float threshold : {0.02f, 0.005f}) {
    params.adaptive = threshold;
    const CountedImage adaptive = picture(built, params);
    const ImageBias off = image_bias(adaptive.image, uniform.image);
    const ImageBias& bound = adaptive_bias_bound;
    EXPECT_LT(std::abs(off.signed_mean), bound.signed_mean * threshold) << threshold;
    EXPECT_LT(off.absolute_mean, bound.absolute_mean * threshold) << threshold;
    EXPECT_LT(off.root_mean_square, bound.root_mean_square * threshold) << threshold;
    EXPECT_LT(adaptive.counts.primary, uniform.counts.primary) << threshold;
  }
}

INSTANTIATE_TEST_SUITE_P(Spd, AdaptiveBias, testing::ValuesIn(spd_scenes()),
                         [](const auto& spd) { return std::string(spd.param.name); });

/// What the colour of ray number `ray` is multiplied with on its way to the eye.
float weight(const Scene& scene, const std::vector<PathRay>& rays, std::size_t ray) {
  if (rays[ray].parent < 0) return 1.0f;
  const auto parent = static_cast<std::size_t>(rays[ray].parent);
  const Material& material = scene.materials[scene.objects[rays[parent].object].material];
  const bool refracts = std::ranges::any_of(rays, [&](const PathRay& other) {
    return other.parent == rays[ray].parent && other.kind == RayKind::refracted;
  });
  const float reflectance = material.specular + (refracts ? 0.0f : material.transmittance);
  const bool is_refracted = rays[ray].kind == RayKind::refracted;
  return weight(scene, rays, parent) * (is_refracted ? material.transmittance : reflectance);
}

TEST(CutOff, TheReflectedAndRefractedRaysOfAtLeastItsWeightAreShot) {
  const Built built(test::random_scene(200, 65));
  RenderParams params = small_picture(1, 0.0f);
  int left_out = 0;
  for (int i = 0; i < params.width * params.height; i += 7) {
    const Vec2 pixel(static_cast<float>(i % params.width) + 0.5f,
                     static_cast<float>(i / params.width) + 0.5f);
    params.cutoff = 0.0f;
    const auto all = trace_pixel(built.world(), built.scene.camera, params, pixel);
    for (const float cutoff : {0.002f, 0.05f, 0.3f, 1.0f}) {
      params.cutoff = cutoff;
      const auto shot = trace_pixel(built.world(), built.scene.camera, params, pixel);
      std::ptrdiff_t heavy = 0;
      for (std::size_t ray = 0; ray < all.size(); ++ray) {
        if (all[ray].kind == RayKind::shadow) continue;
        if (weight(built.scene, all, ray) >= cutoff)
          ++heavy;
        else
          ++left_out;
      }
      const auto traced = std::ranges::count_if(
          shot, [](const PathRay& ray) { return ray.kind != RayKind::shadow; });
      ASSERT_EQ(traced, heavy) << pixel.x << ' ' << pixel.y << ' ' << cutoff;
    }
  }
  EXPECT_GT(left_out, 50);
}

TEST(CutOff, ALightThatIsLeftOutWouldHaveAddedLess) {
  Scene scene = test::random_scene(200, 66);
  for (Material& material : scene.materials) material.specular = material.transmittance = 0.0f;
  const Built built(std::move(scene));
  RenderParams params = small_picture(1, 0.0f);
  const CountedImage whole = picture(built, params);
  for (const float cutoff : {0.002f, 0.01f, 0.05f, 0.2f}) {
    params.cutoff = cutoff;
    const CountedImage cut = picture(built, params);
    EXPECT_LT(cut.counts.shadow, whole.counts.shadow) << cutoff;
    for (std::size_t i = 0; i < whole.image.pixels.size(); ++i) {
      for (int channel = 0; channel < 3; ++channel) {
        const float lost = whole.image.pixels[i][channel] - cut.image.pixels[i][channel];
        ASSERT_TRUE(lost >= 0.0f && lost < 2.0f * cutoff) << lost << ", two lights, " << cutoff;
      }
    }
  }
}

TEST(CutOff, ChangesPicturesByLessThanItselfOnAverage) {
  for (const Built& built : {Built("balls", 2), Built("mount", 3), Built("rings", 1)}) {
    RenderParams params = small_picture(1, 0.0f);
    CountedImage before = picture(built, params);
    const Image whole = before.image;
    for (const float cutoff : {0.002f, 0.01f, 0.05f}) {
      params.cutoff = cutoff;
      const CountedImage cut = picture(built, params);
      EXPECT_LT(image_bias(cut.image, whole).absolute_mean, cutoff)
          << built.scene.name << ' ' << cutoff;
      EXPECT_LE(cut.counts.all(), before.counts.all()) << built.scene.name << ' ' << cutoff;
      before = cut;
    }
  }
}

TEST(CutOff, TheSpdRulesKnowNone) {
  const Built built("balls", 1);
  RenderParams params = small_picture(1, 0.0f);
  params.spd_rules = true;
  const CountedImage whole = picture(built, params);
  params.cutoff = 1.0f;
  const CountedImage cut = picture(built, params);
  EXPECT_EQ(cut.image, whole.image);
  EXPECT_EQ(cut.counts, whole.counts);
}

}  // namespace
}  // namespace bspview
