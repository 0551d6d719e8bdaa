#include "core/bsp/dealt_parts.h"

#include <utility>

#include "core/bsp/clip_part.h"

namespace bspview {
namespace {

/// Deals ranges of parts: first each says how many go to which leaf, then each knows their places.
class Dealer {
 public:
  Dealer(const BuildJob& job, const PartsView& parts, const DealTree& tree)
      : job_(job), parts_(parts), tree_(tree), ranges_(range_count(parts.size())) {
    leaves_.resize(parts.size());
  }

  std::vector<ObjectParts> deal() {
    job_.for_each_range(parts_.size(), [&](std::size_t first, std::size_t last) {
      find_leaves(ranges_[first / range_size], first, last);
    });
    std::vector<ObjectParts> dealt = make_room();
    job_.for_each_range(parts_.size(), [&](std::size_t first, std::size_t last) {
      move(ranges_[first / range_size], first, last, dealt);
    });
    return dealt;
  }

 private:
  static constexpr std::uint32_t several = 0xffffffffu, none = 0xfffffffeu;  // leaves

  struct Piece {
    std::uint32_t leaf;
    ObjectPart part;
  };
  struct Range {
    std::vector<std::uint32_t> places;  // by leaf: how many parts, then where they go
    std::vector<Piece> pieces;          // of objects in several leaves
  };

  void find_leaves(Range& range, std::size_t first, std::size_t last) {
    range.places.assign(tree_.leaf_count, 0);
    for (std::size_t i = first; i < last; ++i) {
      leaves_[i] = leaf_of(parts_.box(i));
      if (leaves_[i] < tree_.leaf_count) {
        ++range.places[leaves_[i]];
      } else if (leaves_[i] == several) {
        divide(range, 0, parts_[i]);
      }
    }
  }

  std::uint32_t leaf_of(const Aabb& box) const {
    if (!is_placeable(box)) return none;
    // Branches are foretold well: objects that follow each other mostly lie together.
    const Node* node = &tree_.nodes[0];
    while (!node->is_leaf()) {
      const Node* const children = &tree_.nodes[node->left()];
      if (component(box.hi, node->axis()) < node->split()) {
        node = children;
      } else if (component(box.lo, node->axis()) > node->split()) {
        node = children + 1;
      } else {
        return several;
      }
    }
    return node->first_reference();
  }

  void divide(Range& range, std::uint32_t index, const ObjectPart& part) const {
    const Node& node = tree_.nodes[index];
    if (node.is_leaf()) {
      ++range.places[node.first_reference()];
      range.pieces.push_back({node.first_reference(), part});
      return;
    }
    const bool goes_left = part.box.lo[node.axis()] <= node.split();
    const bool goes_right = part.box.hi[node.axis()] >= node.split();
    SideBoxes boxes{part.box, part.box};
    if (job_.clip && goes_left && goes_right) {
      const Split split{.axis = node.axis(), .position = node.split()};
      boxes = clip_sides(job_, part.object, {split, tree_.cells[index]});
    }
    if (goes_left && !boxes.left.empty()) divide(range, node.left(), {boxes.left, part.object});
    if (goes_right && !boxes.right.empty()) {
      divide(range, node.right(), {boxes.right, part.object});
    }
  }

  std::vector<ObjectParts> make_room() {
    std::vector<ObjectParts> dealt(tree_.leaf_count);
    for (std::size_t leaf = 0; leaf < dealt.size(); ++leaf) {
      std::uint32_t count = 0;
      for (Range& range : ranges_) count += std::exchange(range.places[leaf], count);
      dealt[leaf].resize(count);
    }
    return dealt;
  }

  void move(Range& range, std::size_t first, std::size_t last,
            std::vector<ObjectParts>& dealt) const {
    const auto put = [&](std::uint32_t leaf, const ObjectPart& part) {
      dealt[leaf][range.places[leaf]++] = part;
    };
    auto piece = range.pieces.begin();
    for (std::size_t i = first; i < last; ++i) {
      if (leaves_[i] == none) continue;
      const ObjectPart part = parts_[i];
      if (leaves_[i] != several) {
        put(leaves_[i], part);
        continue;
      }
      for (; piece != range.pieces.end() && piece->part.object == part.object; ++piece) {
        put(piece->leaf, piece->part);
      }
    }
  }

  const BuildJob& job_;
  const PartsView parts_;
  const DealTree& tree_;
  std::vector<Range> ranges_;
  RawVector<std::uint32_t> leaves_;  // by part
};

}  // namespace

std::vector<ObjectParts> deal_parts(const BuildJob& job, const PartsView& parts,
                                    const DealTree& tree) {
  return Dealer(job, parts, tree).deal();
}

}  // namespace bspview
