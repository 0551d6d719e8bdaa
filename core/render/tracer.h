#pragma once

// Tracers answer the questions of the shader, closest and occluded, about many rays at a time, and
// differ in what they keep: nothing, counts, the rays, or every step.

#include <vector>

#include "core/render/hits.h"
#include "core/render/ray_counts.h"
#include "core/render/render.h"
#include "core/render/shade.h"
#include "core/render/trace.h"

namespace bspview {

/// Asks one ray after the other. One: has Hit closest(ray, role) and bool occluded(ray, role).
template <class One>
class OneByOne : public One {
 public:
  using One::One;
  void closest(std::span<const Ray> rays, std::span<const RayRole> roles, std::span<Hit> hits) {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = One::closest(rays[i], roles[i]);
  }
  void occluded(std::span<const Ray> rays, std::span<const RayRole> roles,
                std::span<char> blocked) {
    for (std::size_t i = 0; i < rays.size(); ++i) blocked[i] = One::occluded(rays[i], roles[i]);
  }
};

/// Keeps nothing: the timed path.
class PlainTracer {
 public:
  PlainTracer(const World& world, const TraceRules& rules)
      : world_(world), rules_(rules), is_fast_(bspview::is_fast(world, rules)) {}
  void closest(std::span<const Ray> rays, std::span<const RayRole>, std::span<Hit> hits) {
    if (is_fast_) return closest_hits(world_, rays, rules_.sides, hits);
    NoObserver none;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      hits[i] = trace_closest(world_, rays[i], rules_, none);
    }
  }
  void occluded(std::span<const Ray> rays, std::span<const RayRole>, std::span<char> blocked) {
    if (is_fast_) {
      blockers_.resize(rays.size());
      any_hits(world_, rays, rules_.shadow_sides, blockers_);
      for (std::size_t i = 0; i < rays.size(); ++i) blocked[i] = blockers_[i] != no_index;
      return;
    }
    NoObserver none;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      blocked[i] = trace_any(world_, rays[i], rules_, none) != no_index;
    }
  }

 private:
  World world_;
  TraceRules rules_;
  bool is_fast_;
  std::vector<std::uint32_t> blockers_;
};

/// Counts rays, visits and tests.
class CountOne {
 public:
  CountOne(const World& world, const TraceRules& rules) : world_(world), rules_(rules) {}
  Hit closest(const Ray& ray, const RayRole& role) {
    CountObserver count(cost_);
    const Hit hit = trace_closest(world_, ray, rules_, count);
    counts_.add_ray(role.kind, static_cast<bool>(hit));
    return hit;
  }
  bool occluded(const Ray& ray, const RayRole& role) {
    CountObserver count(cost_);
    const bool hit = trace_any(world_, ray, rules_, count) != no_index;
    counts_.add_ray(role.kind, hit);
    return hit;
  }
  RayCounts counts() const {
    RayCounts all = counts_;
    all.nodes_inner = cost_.inner;
    all.nodes_leaf = cost_.leaves;
    all.tests = cost_.tests;
    return all;
  }

 private:
  World world_;
  TraceRules rules_;
  RayCost cost_;
  RayCounts counts_;
};
using CountTracer = OneByOne<CountOne>;

/// A ray of a picture and how far it walked.
struct RecordedRay {
  Ray ray;
  std::uint32_t leaves = 0;  ///< of the binary tree, visited until the walk ended
  float end = 0.0f;          ///< t of what it hit, else t_max
  RayKind kind = RayKind::primary;
  bool is_first = false;  ///< of those that were asked about together
};

/// Records every ray.
class RecordTracer {
 public:
  RecordTracer(const World& world, const TraceRules& rules) : world_(world), rules_(rules) {}
  void closest(std::span<const Ray> rays, std::span<const RayRole> roles, std::span<Hit> hits);
  void occluded(std::span<const Ray> rays, std::span<const RayRole> roles, std::span<char> blocked);
  std::vector<RecordedRay>& rays() { return rays_; }

 private:
  World world_;
  TraceRules rules_;
  std::vector<RecordedRay> rays_;
};

/// Keeps every ray with its walk, for one pixel.
class PathOne {
 public:
  PathOne(const World& world, const TraceRules& rules) : world_(world), rules_(rules) {}
  Hit closest(const Ray& ray, const RayRole& role);
  bool occluded(const Ray& ray, const RayRole& role);
  /// Senders come before what they send.
  const std::vector<PathRay>& rays() const { return rays_; }

 private:
  PathRay& start(const Ray& ray, const RayRole& role);

  World world_;
  TraceRules rules_;
  std::vector<PathRay> rays_;
  std::vector<int> index_of_;  // by number of the ray
};
using PathTracer = OneByOne<PathOne>;

/// Asks a kernel that is not known here.
class KernelTracer {
 public:
  explicit KernelTracer(const RayKernel& kernel) : kernel_(kernel) {}
  void closest(std::span<const Ray> rays, std::span<const RayRole> roles, std::span<Hit> hits) {
    if (roles[0].kind == RayKind::primary) return kernel_.eye_hits(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = kernel_.closest(rays[i]);
  }
  void occluded(std::span<const Ray> rays, std::span<const RayRole>, std::span<char> blocked) {
    for (std::size_t i = 0; i < rays.size(); ++i) blocked[i] = kernel_.is_occluded(rays[i]);
  }

 private:
  const RayKernel& kernel_;
};

/// Every object, in double: what pictures are checked against.
class ReferenceOne {
 public:
  ReferenceOne(const Scene& scene, const TraceRules& rules) : scene_(scene), rules_(rules) {}
  Hit closest(const Ray& ray, const RayRole&);
  bool occluded(const Ray& ray, const RayRole&);

 private:
  double hit(std::uint32_t object, const RayQuery& ray, SideRule sides) const;

  const Scene& scene_;
  TraceRules rules_;
};
using ReferenceTracer = OneByOne<ReferenceOne>;

}  // namespace bspview
