#include "core/render/lazy_graft.h"

#include <algorithm>

namespace bspview {
namespace {

using Parts = std::span<const std::shared_ptr<const LazyPart>>;

class Graft {
 public:
  explicit Graft(const Tree& top) : grafted_(top) {
    grafted_.nodes.assign(1, Node::make_leaf(0, 0));
    grafted_.references.clear();
    grafted_.unbuilt.clear();
  }

  /// Puts the root of `tree` at `slot`, everything else at the end.
  void add(const Tree& tree, Parts parts, std::uint32_t slot) {
    const auto first = static_cast<std::uint32_t>(grafted_.nodes.size()) - 1;
    grafted_.nodes.resize(first + tree.nodes.size(), Node::make_leaf(0, 0));
    const auto place = [&](std::uint32_t node) { return node == 0 ? slot : first + node; };
    // Once: rays may build more of them meanwhile.
    std::vector<const Tree*> below;
    for (const auto& part : parts) below.push_back(part->tree());
    std::size_t next = 0;  // part
    for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
      const Node& node = tree.nodes[i];
      if (!node.is_leaf()) {
        grafted_.nodes[place(i)] = Node::make_inner(node.axis(), node.split(), first + node.left());
        continue;
      }
      const bool is_part = next < parts.size() && parts[next]->node() == i;
      if (is_part && below[next++] != nullptr) continue;
      add_leaf(tree, node, place(i));
      if (is_part) grafted_.unbuilt.push_back(place(i));
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (below[i] == nullptr) continue;
      add(*below[i], parts[i]->parts(), place(parts[i]->node()));
    }
  }

  Tree take() {
    std::ranges::sort(grafted_.unbuilt);
    return std::move(grafted_);
  }

 private:
  void add_leaf(const Tree& tree, const Node& leaf, std::uint32_t slot) {
    const auto objects = tree.objects_of(leaf);
    const auto first = static_cast<std::uint32_t>(grafted_.references.size());
    grafted_.references.insert(grafted_.references.end(), objects.begin(), objects.end());
    grafted_.nodes[slot] = Node::make_leaf(first, leaf.count());
  }

  Tree grafted_;
};

}  // namespace

Tree graft_parts(const Tree& top, Parts parts) {
  Graft graft(top);
  graft.add(top, parts, 0);
  return graft.take();
}

}  // namespace bspview
