#pragma once

// What a traversal tells whoever watches it. The kernels are templates over the observer: the one
// that watches nothing leaves no instruction behind.

#include <cstdint>

#include "core/bsp/node.h"
#include "core/bsp/ray_log.h"

namespace bspview {

/// The ray's interval in a cell.
struct RayInterval {
  float enter, exit;
};

struct NoObserver {
  void inner(std::uint32_t, const Node&, StepKind, float, RayInterval) {}
  void leaf(std::uint32_t, RayInterval) {}
  void test(std::uint32_t, bool, double) {}
};

/// Visits and tests of one ray or of many.
struct RayCost {
  std::uint64_t inner = 0, leaves = 0, tests = 0;
  bool operator==(const RayCost&) const = default;
};

class CountObserver {
 public:
  explicit CountObserver(RayCost& cost) : cost_(cost) {}
  void inner(std::uint32_t, const Node&, StepKind, float, RayInterval) { ++cost_.inner; }
  void leaf(std::uint32_t, RayInterval) { ++cost_.leaves; }
  void test(std::uint32_t, bool, double) { ++cost_.tests; }

 private:
  RayCost& cost_;
};

class LogObserver {
 public:
  explicit LogObserver(RayLog& log) : log_(log) {}
  void inner(std::uint32_t index, const Node& node, StepKind kind, float t_split,
             RayInterval interval) {
    log_.steps.push_back({index, kind, node.axis(), node.split(), t_split, interval.enter,
                          interval.exit, test_index(), 0});
  }
  void leaf(std::uint32_t index, RayInterval interval) {
    log_.steps.push_back({.node = index,
                          .kind = StepKind::leaf,
                          .t_enter = interval.enter,
                          .t_exit = interval.exit,
                          .first_test = test_index()});
  }
  void test(std::uint32_t object, bool hit, double t) {
    log_.tests.push_back({object, hit, t});
    ++log_.steps.back().test_count;
  }

 private:
  std::uint32_t test_index() const { return static_cast<std::uint32_t>(log_.tests.size()); }
  RayLog& log_;
};

}  // namespace bspview
