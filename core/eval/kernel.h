#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/eval/ray_set.h"
#include "core/render/world.h"

namespace bspview {

/// One way to answer rays, for measurements of its errors and its speed.
struct Kernel {
  std::string name;  ///< short and stable: a key in files
  std::string what;  ///< one line for people
  /// Answers one result a ray. The world outlives the returned function.
  using Closest = std::function<void(std::span<const Ray>, std::span<RayResult>)>;
  using Occluded = std::function<void(std::span<const Ray>, std::span<char>)>;
  std::function<Closest(const World&)> closest;
  std::function<Occluded(const World&)> occluded;
};

}  // namespace bspview
