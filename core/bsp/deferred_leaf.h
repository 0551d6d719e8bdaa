#pragma once

#include <cstdint>
#include "core/base/raw_vector.h"
#include "core/math/aabb.h"

namespace bspview {

/// The part of an object that lies in a node, by its box.
struct ObjectPart {
  Aabb box;
  std::uint32_t object = 0;
};
using ObjectParts = RawVector<ObjectPart>;

/// A node's place in the tree.
struct Place {
  Aabb cell;
  int depth = 0;
  double work = 0.0;  ///< from here down, to be told of (BuildProgress)
};

/// A leaf that a builder would split but has put off.
struct DeferredLeaf {
  std::uint32_t node = 0;  ///< of the tree
  Place place;
  ObjectParts parts;  ///< in ascending order of their objects
};

}  // namespace bspview
