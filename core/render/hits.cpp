#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/hits.cpp"
#include <hwy/foreach_target.h>  // before highway.h
//
#include <hwy/highway.h>

#include <type_traits>

#include "core/render/hits.h"
#include "core/render/lazy_walk.h"
#include "core/render/packet_group-inl.h"
#include "core/render/single_ray-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bspview::HWY_NAMESPACE {
namespace {

template <bool any>
Hit find_in_binary_tree(const World& world, const Ray& ray, SideRule rule) {
  if (world.lazy != nullptr) return find_in_parts(world, ray, rule, any);
  NoObserver none;
  const TraceRules rules{.sides = rule, .shadow_sides = rule};
  if (any) return {0.0, any_hit(world, ray, rules, none), no_leaf};
  Hit hit = closest_hit(world, ray, rules, none);
  hit.leaf = no_leaf;
  return hit;
}

template <bool any>
HWY_INLINE Hit find_alone(const World& world, const Ray& ray, SideRule rule) {
  if (world.accelerator == nullptr || !is_plain(ray)) {
    return find_in_binary_tree<any>(world, ray, rule);
  }
  return trace_single_ray<any>(world, ray, rule);
}

/// Calls work(group, first, some) for rays after rays, as many as go together.
template <class Work>
void for_each_group(const World& world, std::span<const Ray> rays, SideRule rule,
                    const Work& work) {
  PacketGroup group(world, rule);
  const std::size_t width = PacketGroup::width();
  for (std::size_t first = 0; first < rays.size(); first += width) {
    work(group, first, rays.subspan(first, std::min(width, rays.size() - first)));
  }
}

void set(Hit& to, const Hit& hit) {
  to = hit;
}
void set(std::uint32_t& to, const Hit& hit) {
  to = hit.object;
}

/// Answer: Hit, of the nearest; or the number of any object.
template <class Answer>
void trace_all(const World& world, std::span<const Ray> rays, SideRule rule,
               std::span<Answer> answers) {
  constexpr bool any = !std::is_same_v<Answer, Hit>;
  if (world.accelerator == nullptr) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      set(answers[i], find_alone<any>(world, rays[i], rule));
    }
    return;
  }
  for_each_group(world, rays, rule, [&](PacketGroup& group, std::size_t first, auto some) {
    group.trace<any>(some);
    const std::span<Answer> here = answers.subspan(first, some.size());
    group.store(here);
    group.for_each_alone(
        [&](std::size_t i) { set(here[i], find_alone<any>(world, some[i], rule)); });
  });
}

Hit fast_closest_hit_here(const World& world, const Ray& ray, SideRule rule) {
  return find_alone<false>(world, ray, rule);
}

std::uint32_t fast_any_hit_here(const World& world, const Ray& ray, SideRule rule) {
  return find_alone<true>(world, ray, rule).object;
}

std::uint64_t walk_alone_here(const World& world, const Ray& ray, bool walks) {
  if (!is_plain(ray)) return 0;
  const WideRay wide(ray);
  std::uint64_t sum =
      static_cast<std::uint64_t>(wide.near_row[0]);  // lest making ready be left out
  const float reach = ray.t_max * hit_margin;
  const auto pass = [&](const Accelerator&, std::uint32_t child) { sum += child; };
  if (walks) traverse_parts(*world.accelerator, wide, reach, pass);
  return sum;
}

std::uint64_t walk_together_here(const World& world, std::span<const Ray> rays, bool walks) {
  std::uint64_t sum = 0;
  for_each_group(world, rays, SideRule::two_sided, [&](PacketGroup& group, std::size_t, auto some) {
    sum += group.walk(some, walks);
    group.for_each_alone([&](std::size_t i) { sum += walk_alone_here(world, some[i], walks); });
  });
  return sum;
}

void closest_hits_here(const World& world, std::span<const Ray> rays, SideRule rule,
                       std::span<Hit> hits) {
  trace_all(world, rays, rule, hits);
}

void any_hits_here(const World& world, std::span<const Ray> rays, SideRule rule,
                   std::span<std::uint32_t> objects) {
  trace_all(world, rays, rule, objects);
}

int width_here() {
  return lane_count();
}
const char* instructions_here() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace
}  // namespace bspview::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bspview {

HWY_EXPORT(fast_closest_hit_here);
HWY_EXPORT(fast_any_hit_here);
HWY_EXPORT(walk_together_here);
HWY_EXPORT(walk_alone_here);
HWY_EXPORT(closest_hits_here);
HWY_EXPORT(any_hits_here);
HWY_EXPORT(width_here);
HWY_EXPORT(instructions_here);

Hit fast_closest_hit(const World& world, const Ray& ray, SideRule rule) {
  return HWY_DYNAMIC_DISPATCH(fast_closest_hit_here)(world, ray, rule);
}

std::uint32_t fast_any_hit(const World& world, const Ray& ray, SideRule rule) {
  return HWY_DYNAMIC_DISPATCH(fast_any_hit_here)(world, ray, rule);
}

std::uint64_t walk_together(const World& world, std::span<const Ray> rays, bool walks) {
  return HWY_DYNAMIC_DISPATCH(walk_together_here)(world, rays, walks);
}

std::uint64_t walk_alone(const World& world, const Ray& ray, bool walks) {
  return HWY_DYNAMIC_DISPATCH(walk_alone_here)(world, ray, walks);
}

void closest_hits(const World& world, std::span<const Ray> rays, SideRule rule,
                  std::span<Hit> hits) {
  HWY_DYNAMIC_DISPATCH(closest_hits_here)(world, rays, rule, hits);
}

void any_hits(const World& world, std::span<const Ray> rays, SideRule rule,
              std::span<std::uint32_t> objects) {
  HWY_DYNAMIC_DISPATCH(any_hits_here)(world, rays, rule, objects);
}

int packet_width() {
  return HWY_DYNAMIC_DISPATCH(width_here)();
}

const char* packet_instructions() {
  return HWY_DYNAMIC_DISPATCH(instructions_here)();
}

}  // namespace bspview
#endif
