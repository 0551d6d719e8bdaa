#pragma once

// After Whitted 1980, "An improved illumination model for shaded display", with Phong highlights
// and the rules of the Standard Procedural Databases.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/render/render.h"
#include "core/render/surface.h"

namespace bspview {

/// What a tracer is told of a ray besides where it runs.
struct RayRole {
  RayKind kind = RayKind::primary;
  int level = 1;    ///< of an eye ray 1, of others one more than that of the ray that sends them
  int number = -1;  ///< counts the rays that are no shadow rays
  int sender = -1;  ///< number of the ray that sends it; -1: the eye
};

/// Colour along rays. Rays of one level and kind are traced together, all that a set of points
/// sends to a light at once, so that a tracer can take many at a time. Tracer: see tracer.h.
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

  /// What eye rays hit, and the colours along them.
  void trace(std::span<const Ray> rays, std::span<Hit> hits, std::span<Vec3> colors) {
    Wave wave;
    for (const Ray& ray : rays) wave.add(ray, {RayKind::primary, 1, next_number_++}, {});
    trace(wave);
    std::ranges::copy(wave.hits, hits.begin());
    std::ranges::copy(wave.colors, colors.begin());
  }

 private:
  /// Sent rays wait for more until there are as many, lest memory grow with their level.
  static constexpr std::size_t many_rays = 256;

  /// To which point a ray's colour goes.
  struct Purpose {
    std::size_t point = 0;
    float share = 1.0f;   ///< of the ray's colour in that of the point
    float weight = 1.0f;  ///< of the ray
  };

  // What follows fills its vectors in place, v.emplace_back() = x: to copy what was written a
  // moment ago, in other pieces, would wait for the memory (store forwarding), a tenth of a
  // picture.

  /// Rays of one level and kind.
  struct Wave {
    std::vector<Ray> rays;
    std::vector<RayRole> roles;
    std::vector<Purpose> purposes;
    std::vector<Hit> hits;
    std::vector<Vec3> colors;

    void add(const Ray& ray, const RayRole& role, const Purpose& purpose) {
      rays.emplace_back() = ray;
      roles.emplace_back() = role;
      purposes.emplace_back() = purpose;
    }
  };

  /// What points send: each kind by itself, so that neighbours run the same way.
  struct Sent {
    Wave refracted, reflected;
  };

  /// Where a ray of a wave hit something.
  struct Point {
    Point(const Scene& scene, const Wave& wave, std::size_t number)
        : ray(number),
          surface(surface_at(scene, wave.rays[ray], wave.hits[ray])),
          view(glm::normalize(Vec3d(wave.rays[ray].direction))),
          mirrored(glm::reflect(view, surface.shading_normal)) {}

    std::size_t ray;  ///< in the wave
    Surface surface;
    Vec3d view;                    ///< direction of the ray, of length 1
    Vec3d mirrored;                ///< the view, reflected
    Vec3 local{0.0f}, sent{0.0f};  ///< colour by lights, and along the rays that the point sends
  };

  /// Points and the rays that hit them.
  struct Lit {
    const Wave& wave;
    std::vector<Point> points;
  };

  void trace(Wave& wave) {
    if (wave.rays.empty()) return;
    wave.hits.resize(wave.rays.size());
    wave.colors.assign(wave.rays.size(), scene_.background);
    tracer_.closest(wave.rays, wave.roles, wave.hits);
    Lit lit{wave, {}};
    lit.points.reserve(wave.rays.size());
    for (std::size_t i = 0; i < wave.rays.size(); ++i) {
      if (wave.hits[i]) add_ambient(lit.points.emplace_back(scene_, wave, i));
    }
    if (lit.points.empty()) return;
    for (const Light& light : scene_.lights) add_light(lit, light);
    if (wave.roles[0].level < max_level_) send_rays(lit);
    for (const Point& point : lit.points) wave.colors[point.ray] = point.local + point.sent;
  }

  void add_ambient(Point& point) const {
    const Material& material = *point.surface.material;
    point.local = intensity_ * (material.diffuse * material.color);
  }

  /// A point that a light reaches if nothing is in the way.
  struct Facing {
    Point* point;
    double cosine;     ///< of the angle of the light to the normal
    double highlight;  ///< of its angle to the mirrored view
  };

  /// The shadow rays to one light.
  struct Shadows {
    explicit Shadows(std::size_t most) {
      points.reserve(most);
      rays.reserve(most);
      roles.reserve(most);
    }

    std::vector<Facing> points;  ///< that send them
    std::vector<Ray> rays;
    std::vector<RayRole> roles;
    std::vector<char> blocked;
  };

  /// Diffuse light and highlights.
  void add_light(Lit& lit, const Light& light) {
    Shadows shadows(lit.points.size());
    for (Point& point : lit.points) aim(point, light, lit.wave, shadows);
    shadows.blocked.resize(shadows.rays.size());
    tracer_.occluded(shadows.rays, shadows.roles, shadows.blocked);
    for (std::size_t i = 0; i < shadows.points.size(); ++i) {
      const Facing& facing = shadows.points[i];
      if (!shadows.blocked[i]) facing.point->local += light_share(facing, light);
    }
  }

  /// Adds the shadow ray of a point, if it sends one.
  void aim(Point& point, const Light& light, const Wave& wave, Shadows& shadows) const {
    const Facing facing = face(point, light);
    if (!(facing.cosine > 0.0)) return;
    if (cutoff_ > 0.0f) [[unlikely]] {
      const Vec3 share = light_share(facing, light);
      const float weight = wave.purposes[point.ray].weight;
      if (weight * std::max({share.x, share.y, share.z}) < cutoff_) return;
    }
    const RayRole& sender = wave.roles[point.ray];
    shadows.points.emplace_back() = facing;
    shadows.rays.emplace_back() = shadow_ray(point.surface, light, offset_);
    shadows.roles.emplace_back() = {RayKind::shadow, sender.level + 1, -1, sender.number};
  }

  /// How a point stands to a light; a cosine of 0 where it turns its back to it or does not care.
  static Facing face(Point& point, const Light& light) {
    const Surface& surface = point.surface;
    const Facing none{&point, 0.0, 0.0};
    if (surface.material->diffuse <= 0.0f && surface.material->specular <= 0.0f) return none;
    const Vec3d way = glm::normalize(Vec3d(light.position) - surface.point);
    const double cosine = glm::dot(surface.shading_normal, way);
    if (!(cosine > 0.0) || glm::dot(surface.normal, way) <= 0.0) return none;
    return {&point, cosine, std::max(0.0, glm::dot(point.mirrored, way))};
  }

  /// Of the colour of a point that the light reaches.
  Vec3 light_share(const Facing& facing, const Light& light) const {
    const Material& material = *facing.point->surface.material;
    const Vec3 diffuse = material.diffuse * material.color;
    const float gloss =
        material.specular > 0.0f
            ? material.specular * static_cast<float>(std::pow(facing.highlight, material.shine))
            : 0.0f;
    return intensity_ * light.color * (static_cast<float>(facing.cosine) * diffuse + Vec3(gloss));
  }

  /// Reflection and refraction; a ray is sent only where its colour counts, or, under the SPD's
  /// rules, wherever they ask for one.
  void send_rays(Lit& lit) {
    Sent next;
    for (std::size_t i = 0; i < lit.points.size(); ++i) {
      send_rays(lit, i, next);
      for (Wave* wave : {&next.refracted, &next.reflected}) {
        if (wave->rays.size() >= many_rays) collect(lit, *wave);
      }
    }
    collect(lit, next.refracted);
    collect(lit, next.reflected);
  }

  void send_rays(const Lit& lit, std::size_t index, Sent& next) {
    const Point& point = lit.points[index];
    const Material& material = *point.surface.material;
    const bool transparent = material.transmittance > 0.0f;
    if (!(material.specular > 0.0f) && !transparent) return;
    const RayRole& sender = lit.wave.roles[point.ray];
    const float weight = lit.wave.purposes[point.ray].weight;
    const auto send = [&](RayKind kind, Vec3d direction, float share) {
      if (weight * share < cutoff_) return;
      Wave& wave = kind == RayKind::refracted ? next.refracted : next.reflected;
      wave.add(leaving_ray(point.surface, direction, offset_),
               {kind, sender.level + 1, next_number_++, sender.number},
               {index, share, weight * share});
    };
    float reflectance = material.specular;
    if (transparent) {
      if (const auto direction = refracted(point.surface, point.view)) {
        send(RayKind::refracted, *direction, material.transmittance);
      } else {
        reflectance += material.transmittance;  // total internal reflection
      }
    }
    if (reflectance > 0.0f || every_ray_) send(RayKind::reflected, reflected(point), reflectance);
  }

  /// Traces what was sent, and gives the points their colours.
  void collect(Lit& lit, Wave& sent) {
    trace(sent);
    for (std::size_t i = 0; i < sent.rays.size(); ++i) {
      const Purpose& purpose = sent.purposes[i];
      lit.points[purpose.point].sent += purpose.share * sent.colors[i];
    }
    sent = {};
  }

  /// About the shading normal, unless that would lead below the surface.
  static Vec3d reflected(const Point& point) {
    if (glm::dot(point.mirrored, point.surface.normal) > 0.0) return point.mirrored;
    return glm::reflect(point.view, point.surface.normal);
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
  int next_number_ = 0;
};

}  // namespace bspview
