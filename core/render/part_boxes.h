#pragma once

#include <span>
#include <vector>

#include "core/bsp/deferred_leaf.h"
#include "core/bsp/wide_tree.h"
#include "core/scene/scene.h"

namespace bspview {

/// Boxes around few objects, as they come: rays that are few do not pay for better ones.
class PartBoxes {
 public:
  PartBoxes(const Scene& scene, std::span<const ObjectPart> parts);

  const WideLeaves& leaves() const { return leaves_; }
  /// Of leaves by their number.
  RawVector<WideNode> make_nodes();

 private:
  struct Child {
    Aabb box;
    std::uint32_t name;
  };

  void add(std::uint32_t object, const Aabb& box, std::uint32_t most);
  Child add_node(std::size_t first, RawVector<WideNode>& nodes) const;
  static WideNode node_of(std::span<const Child> children);

  WideLeaves leaves_;
  std::vector<Child> children_;
};

}  // namespace bspview
