#pragma once

#include <optional>
#include <string_view>

#include "core/eval/bench/rays.h"
#include "core/render/accelerator.h"

namespace bspview::test {

/// A standard scene, its tree, its wide nodes, and rays that `bspeval bench` would send.
class RecordedWorld {
 public:
  /// About `count` rays; without `size`, the standard one.
  RecordedWorld(std::string_view spd, std::optional<int> size, BenchKind kind, std::size_t count);

  const World& world() const { return fast_.world(); }
  const std::vector<Ray>& rays() const { return rays_; }

 private:
  const Scene scene_;
  const Tree tree_;
  const FastWorld fast_;
  const std::vector<Ray> rays_;
};

}  // namespace bspview::test
