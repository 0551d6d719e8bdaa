#include "tests/bench/recorded_world.h"

#include "core/base/check.h"
#include "core/render/scene_tree.h"
#include "core/scene/spd.h"

namespace bspview::test {
namespace {

template <class T>
T value_of(Result<T> result) {
  BSPVIEW_CHECK(result);
  return std::move(*result);
}

}  // namespace

RecordedWorld::RecordedWorld(std::string_view spd, std::optional<int> size, BenchKind kind,
                             std::size_t count)
    : scene_(value_of(make_spd(spd, size))),
      tree_(value_of(build_scene_tree(scene_, {}))),
      fast_(World{scene_, tree_}),
      rays_(record_bench_rays(world(), kind, count, 1).rays) {}

}  // namespace bspview::test
