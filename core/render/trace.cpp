#include "core/render/trace.h"

#include "core/bsp/observer.h"
#include "core/render/textbook_shapes.h"

namespace bspview {
namespace {

/// Calls work with the shape tests of `arithmetic`.
template <class Work>
auto with_shapes(Arithmetic arithmetic, const Work& work) {
  switch (arithmetic) {
    case Arithmetic::textbook:
      return work(MixedShapes<MoellerFaces<float>, FloatQuadrics>());
    case Arithmetic::woop:
      return work(MixedShapes<WoopFaces, FloatQuadrics>());
    case Arithmetic::in_double:
      return work(MixedShapes<MoellerFaces<double>, DoubleQuadrics>());
    case Arithmetic::exact:
      break;
  }
  return work(ExactShapes());
}

}  // namespace

template <class Observer>
Hit closest_hit_otherwise(const World& world, const Ray& ray, const TraceRules& rules,
                          Observer& observer) {
  return with_shapes(rules.arithmetic, [&]<class Shapes>(Shapes) {
    return closest_hit<Shapes>(world, ray, rules, observer);
  });
}

template <class Observer>
std::uint32_t any_hit_otherwise(const World& world, const Ray& ray, const TraceRules& rules,
                                Observer& observer) {
  return with_shapes(rules.arithmetic, [&]<class Shapes>(Shapes) {
    return any_hit<Shapes>(world, ray, rules, observer);
  });
}

template Hit closest_hit_otherwise(const World&, const Ray&, const TraceRules&, NoObserver&);
template Hit closest_hit_otherwise(const World&, const Ray&, const TraceRules&, CountObserver&);
template Hit closest_hit_otherwise(const World&, const Ray&, const TraceRules&, LogObserver&);
template std::uint32_t any_hit_otherwise(const World&, const Ray&, const TraceRules&, NoObserver&);
template std::uint32_t any_hit_otherwise(const World&, const Ray&, const TraceRules&,
                                         CountObserver&);
template std::uint32_t any_hit_otherwise(const World&, const Ray&, const TraceRules&, LogObserver&);

}  // namespace bspview
