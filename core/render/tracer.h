#pragma once

// Tracers answer the questions of the shader, eye_hits, closest and occluded, and differ in what
// they keep: nothing, counts, the rays, or every step.

#include <vector>

#include "core/render/hits.h"
#include "core/render/ray_counts.h"
#include "core/render/render.h"
#include "core/render/trace.h"

namespace bspview {

/// eye_hits of tracers that take one ray after the other.
template <class Tracer>
void find_eye_hits(Tracer& tracer, std::span<const Ray> rays, std::span<Hit> hits) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = tracer.closest(rays[i], RayKind::primary, 1);
  }
}

/// Keeps nothing: the timed path.
class PlainTracer {
 public:
  PlainTracer(const World& world, const TraceRules& rules)
      : world_(world), rules_(rules), is_fast_(bspview::is_fast(world, rules)) {}
  void eye_hits(std::span<const Ray> rays, std::span<Hit> hits) {
    if (is_fast_) return closest_hits(world_, rays, rules_.sides, hits);
    find_eye_hits(*this, rays, hits);
  }
  Hit closest(const Ray& ray, RayKind, int) {
    if (is_fast_) return fast_closest_hit(world_, ray, rules_.sides);
    NoObserver none;
    return trace_closest(world_, ray, rules_, none);
  }
  bool occluded(const Ray& ray, int) {
    if (is_fast_) return fast_any_hit(world_, ray, rules_.shadow_sides) != no_index;
    NoObserver none;
    return trace_any(world_, ray, rules_, none) != no_index;
  }

 private:
  World world_;
  TraceRules rules_;
  bool is_fast_;
};

/// Counts rays, visits and tests.
class CountTracer {
 public:
  CountTracer(const World& world, const TraceRules& rules) : world_(world), rules_(rules) {}
  void eye_hits(std::span<const Ray> rays, std::span<Hit> hits) {
    find_eye_hits(*this, rays, hits);
  }
  Hit closest(const Ray& ray, RayKind kind, int) {
    CountObserver count(cost_);
    const Hit hit = trace_closest(world_, ray, rules_, count);
    counts_.add_ray(kind, static_cast<bool>(hit));
    return hit;
  }
  bool occluded(const Ray& ray, int) {
    CountObserver count(cost_);
    const bool hit = trace_any(world_, ray, rules_, count) != no_index;
    counts_.add_ray(RayKind::shadow, hit);
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

/// A ray of a picture and how far it walked.
struct RecordedRay {
  Ray ray;
  std::uint32_t leaves = 0;  ///< of the binary or the wide tree, visited until the walk ended
  float end = 0.0f;          ///< t of what it hit, else t_max
  RayKind kind = RayKind::primary;
};

/// Records every ray.
class RecordTracer {
 public:
  RecordTracer(const World& world, const TraceRules& rules) : world_(world), rules_(rules) {}
  void eye_hits(std::span<const Ray> rays, std::span<Hit> hits) {
    find_eye_hits(*this, rays, hits);
  }
  Hit closest(const Ray& ray, RayKind kind, int) {
    RayCost cost;
    CountObserver count(cost);
    const Hit hit = trace_closest(world_, ray, rules_, count);
    const float end = hit ? static_cast<float>(hit.t) : ray.t_max;
    rays_.push_back({ray, leaves_of(ray, cost, false), end, kind});
    return hit;
  }
  bool occluded(const Ray& ray, int) {
    RayCost cost;
    CountObserver count(cost);
    const bool hit = trace_any(world_, ray, rules_, count) != no_index;
    rays_.push_back({ray, leaves_of(ray, cost, true), ray.t_max, RayKind::shadow});
    return hit;
  }
  std::vector<RecordedRay>& rays() { return rays_; }

 private:
  std::uint32_t leaves_of(const Ray& ray, const RayCost& cost, bool any) const {
    if (is_fast(world_, rules_)) return count_leaves(world_, ray, rules_, any);
    return static_cast<std::uint32_t>(cost.leaves);
  }

  World world_;
  TraceRules rules_;
  std::vector<RecordedRay> rays_;
};

/// Keeps every ray with its walk, for one pixel.
class PathTracer {
 public:
  PathTracer(const World& world, const TraceRules& rules) : world_(world), rules_(rules) {}
  void eye_hits(std::span<const Ray> rays, std::span<Hit> hits) {
    find_eye_hits(*this, rays, hits);
  }
  Hit closest(const Ray& ray, RayKind kind, int level);
  bool occluded(const Ray& ray, int level);
  std::vector<PathRay>& rays() { return rays_; }

 private:
  PathRay& start(const Ray& ray, RayKind kind, int level);

  World world_;
  TraceRules rules_;
  std::vector<PathRay> rays_;
  std::vector<int> last_at_level_;  // index of the last ray that is no shadow ray; index: level
};

/// Asks a kernel that is not known here.
class KernelTracer {
 public:
  explicit KernelTracer(const RayKernel& kernel) : kernel_(kernel) {}
  void eye_hits(std::span<const Ray> rays, std::span<Hit> hits) {
    kernel_.eye_hits(rays, hits);
  }
  Hit closest(const Ray& ray, RayKind, int) { return kernel_.closest(ray); }
  bool occluded(const Ray& ray, int) { return kernel_.is_occluded(ray); }

 private:
  const RayKernel& kernel_;
};

/// Every object, in double: what pictures are checked against.
class ReferenceTracer {
 public:
  ReferenceTracer(const Scene& scene, const TraceRules& rules) : scene_(scene), rules_(rules) {}
  void eye_hits(std::span<const Ray> rays, std::span<Hit> hits) {
    find_eye_hits(*this, rays, hits);
  }
  Hit closest(const Ray& ray, RayKind, int);
  bool occluded(const Ray& ray, int level);

 private:
  double hit(std::uint32_t object, const RayQuery& ray, SideRule sides) const;

  const Scene& scene_;
  TraceRules rules_;
};

}  // namespace bspview
