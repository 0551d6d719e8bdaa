#pragma once

// After Whitted 1980, "An improved illumination model for shaded display", with Phong highlights
// and the rules of the Standard Procedural Databases.

#include <algorithm>
#include <cmath>
#include <span>

#include "core/render/render.h"
#include "core/render/surface.h"

namespace bspview {

/// Colour along rays, recursively. Tracer: see tracer.h.
///
/// The weight of a ray is the product of the factors (Ks, T, or both together after total internal
/// reflection) that scale its colour on the way back to the eye; it is 1 for the eye ray. With a
/// cut-off c > 0 these rays are not shot, and count as black:
/// - reflected and refracted rays of a weight below c: the picture loses less than c times what
///   they would have seen;
/// - shadow rays when weight times the largest channel of the light's share (Phong, unshadowed) is
///   below c: the point counts as shadowed, the picture loses less than c for each light.
/// The SPD's rules, which prescribe every ray, know no cut-off.
template <class Tracer>
class Shader {
 public:
  Shader(const Scene& scene, const RenderParams& params, Tracer& tracer)
      : scene_(scene),
        tracer_(tracer),
        max_level_(params.max_ray_depth),
        every_ray_(params.spd_rules),
        offset_(params.offset),
        cutoff_(params.spd_rules ? 0.0f : params.cutoff),
        intensity_(0.5f /
                   std::sqrt(std::max<float>(1.0f, static_cast<float>(scene.lights.size())))) {}

  /// Colour seen along an eye ray; what it hit goes to `hit`.
  Vec3 eye_color(const Ray& ray, Hit& hit) {
    hit = tracer_.closest(ray, RayKind::primary, 1);
    return color(ray, hit);
  }

  /// The same in two steps, for many rays: what eye rays hit, and the colour along one.
  void eye_hits(std::span<const Ray> rays, std::span<Hit> hits) { tracer_.eye_hits(rays, hits); }
  Vec3 color(const Ray& ray, const Hit& hit) {
    return hit ? shade(ray, hit, {1, 1.0f}) : scene_.background;
  }

 private:
  /// How a ray stands to the eye.
  struct Path {
    int level;
    float weight;
  };

  /// The colour times its `share` of the ray before, whose path is `path`.
  Vec3 color_along(const Ray& ray, RayKind kind, Path path, float share) {
    const Path next{path.level + 1, path.weight * share};
    if (next.weight < cutoff_) return Vec3(0.0f);
    const Hit hit = tracer_.closest(ray, kind, next.level);
    return share * (hit ? shade(ray, hit, next) : scene_.background);
  }

  Vec3 shade(const Ray& ray, const Hit& hit, Path path) {
    const Surface surface = surface_at(scene_, ray, hit);
    const Vec3d view = glm::normalize(Vec3d(ray.direction));
    Vec3 color = local_color(surface, view, path);
    if (path.level < max_level_) color += secondary_color(surface, view, path);
    return color;
  }

  /// Ambient, diffuse and highlight.
  Vec3 local_color(const Surface& surface, Vec3d view, Path path) {
    const Material& material = *surface.material;
    Vec3 color = intensity_ * (material.diffuse * material.color);
    if (material.diffuse <= 0.0f && material.specular <= 0.0f) return color;
    const Vec3d mirrored = glm::reflect(view, surface.shading_normal);
    for (const Light& light : scene_.lights) {
      const Vec3d to_light = Vec3d(light.position) - surface.point;
      const Vec3d way = glm::normalize(to_light);
      const double cosine = glm::dot(surface.shading_normal, way);
      if (!(cosine > 0.0) || glm::dot(surface.normal, way) <= 0.0) continue;
      const double highlight = std::max(0.0, glm::dot(mirrored, way));
      if (cutoff_ > 0.0f) [[unlikely]] {
        const Vec3 share = light_share(material, light, cosine, highlight);
        if (path.weight * std::max({share.x, share.y, share.z}) < cutoff_) continue;
      }
      if (!in_shadow(surface, light, path.level)) {
        color += light_share(material, light, cosine, highlight);
      }
    }
    return color;
  }

  /// Of the colour of a point that the light reaches; `cosine` is that of its angle to the normal,
  /// `highlight` that of its angle to the mirrored view.
  Vec3 light_share(const Material& material, const Light& light, double cosine,
                   double highlight) const {
    const Vec3 diffuse = material.diffuse * material.color;
    const float gloss =
        material.specular > 0.0f
            ? material.specular * static_cast<float>(std::pow(highlight, material.shine))
            : 0.0f;
    return intensity_ * light.color * (static_cast<float>(cosine) * diffuse + Vec3(gloss));
  }

  bool in_shadow(const Surface& surface, const Light& light, int level) {
    return tracer_.occluded(shadow_ray(surface, light, offset_), level);
  }

  /// Reflection and refraction; a ray is sent only where its colour counts, or, under the SPD's
  /// rules, wherever they ask for one.
  Vec3 secondary_color(const Surface& surface, Vec3d view, Path path) {
    const Material& material = *surface.material;
    const bool transparent = material.transmittance > 0.0f;
    if (!(material.specular > 0.0f) && !transparent) return Vec3(0.0f);
    Vec3 color(0.0f);
    float reflectance = material.specular;
    if (transparent) {
      if (const auto direction = refracted(surface, view)) {
        color += color_along(leaving_ray(surface, *direction, offset_), RayKind::refracted, path,
                             material.transmittance);
      } else {
        reflectance += material.transmittance;  // total internal reflection
      }
    }
    if (reflectance > 0.0f || every_ray_) {
      const Vec3d direction = reflected(surface, view);
      color += color_along(leaving_ray(surface, direction, offset_), RayKind::reflected, path,
                           reflectance);
    }
    return color;
  }

  /// About the shading normal, unless that would lead below the surface.
  static Vec3d reflected(const Surface& surface, Vec3d view) {
    const Vec3d smooth = glm::reflect(view, surface.shading_normal);
    if (glm::dot(smooth, surface.normal) > 0.0) return smooth;
    return glm::reflect(view, surface.normal);
  }

  /// Snell's law; nullopt at total internal reflection.
  static std::optional<Vec3d> refracted(const Surface& surface, Vec3d view) {
    const double index = surface.material->refraction_index;
    const double eta = surface.from_behind ? index : 1.0 / index;
    const double cosine = -glm::dot(view, surface.normal);
    const double k = 1.0 - eta * eta * (1.0 - cosine * cosine);
    if (!(index > 0.0) || !(k >= 0.0)) return std::nullopt;
    return eta * view + (eta * cosine - std::sqrt(k)) * surface.normal;
  }

  const Scene& scene_;
  Tracer& tracer_;
  int max_level_;
  bool every_ray_;
  OffsetRule offset_;
  float cutoff_;
  float intensity_;  // of each light and of the ambient light
};

}  // namespace bspview
