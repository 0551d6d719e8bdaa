#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace bspview {

/// One scene of the Standard Procedural Databases (Haines, IEEE CG&A 7(11), 1987; version 3.14).
struct SpdScene {
  std::string_view name;
  int standard_size = 1;  ///< size factor of the published scene
  bool has_size = true;   ///< false: the scene is one fixed object list
};

/// The thirteen scenes, by name in alphabetic order.
std::span<const SpdScene> spd_scenes();

/// Generates one; without `size`, the standard one. An unknown name, a size that is not valid or
/// makes more than `max_spd_objects` objects is refused with a sentence (which says how many).
Result<Scene> make_spd(std::string_view name, std::optional<int> size = std::nullopt);

inline constexpr double max_spd_objects = 2e7;

/// Number of objects that make_spd would make, without making them; in double, since an absurd
/// size overflows every integer.
Result<double> count_spd_objects(std::string_view name, int size);

}  // namespace bspview
