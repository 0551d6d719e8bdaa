#include "core/render/accelerator.h"

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/render/hit_bounds.h"
#include "core/render/lazy_part.h"
#include "core/render/part_boxes.h"

namespace bspview {
namespace {

// Objects, leaves or nodes between two looks at the stop token: each well below a millisecond.
constexpr std::size_t range_size = 1024;

bool is_triangle(const Scene& scene, std::uint32_t object) {
  return scene.objects[object].kind == ObjectKind::triangle;
}

WideObject wide_object(const Scene& scene, std::uint32_t id) {
  return {hit_bounds(scene, id), is_triangle(scene, id)};
}

/// What rays can hit of the objects in a leaf that was put off, in its cell.
Aabb hit_bounds(const Scene& scene, const LazyPart& part) {
  return intersection(hit_bounds(scene, part.objects()), part.place().cell);
}

/// A tree whose objects are numbered from 0 on, so that few take little room; each leaf that was
/// put off holds one object more.
class LocalTree {
 public:
  LocalTree(const Scene& scene, const Tree& tree,
            std::span<const std::shared_ptr<const LazyPart>> parts)
      : scene_(scene),
        first_part_(static_cast<std::uint32_t>(scene.objects.size())),
        tree_(tree) {
    find_ids(parts);
    number(parts);
    objects_.resize(ids_.size() + parts.size());
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      objects_[i] = wide_object(scene, ids_[i]);
    }
    parallel_for(static_cast<int>(parts.size()), [&](int i) {
      const auto part = static_cast<std::size_t>(i);
      objects_[ids_.size() + part] = {.box = hit_bounds(scene, *parts[part]), .is_alone = true};
    });
  }

  const Tree& tree() const { return tree_; }
  WideObjects objects() const {
    return {objects_, [this](std::uint32_t object, const Aabb& cell) {
              return hit_bounds(scene_, name_of(object), objects_[object].box, cell);
            }};
  }
  /// The id of an object; parts come behind all objects of the scene.
  std::uint32_t name_of(std::uint32_t object) const {
    if (object < ids_.size()) return ids_[object];
    return first_part_ + object - static_cast<std::uint32_t>(ids_.size());
  }

 private:
  using Parts = std::span<const std::shared_ptr<const LazyPart>>;

  /// Calls leaf(node) for all leaves, part(node, number) for those that were put off.
  template <class Leaf, class Part>
  void for_each_leaf(Parts parts, const Leaf& leaf, const Part& part) {
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < tree_.nodes.size(); ++i) {
      if (!tree_.nodes[i].is_leaf()) continue;
      if (next < parts.size() && parts[next]->node() == i) {
        part(tree_.nodes[i], next++);
      } else {
        leaf(tree_.nodes[i]);
      }
    }
  }

  void find_ids(Parts parts) {
    for_each_leaf(
        parts,
        [&](const Node& leaf) {
          const auto objects = tree_.objects_of(leaf);
          ids_.insert(ids_.end(), objects.begin(), objects.end());
        },
        [](const Node&, std::uint32_t) {});
    std::ranges::sort(ids_);
    ids_.erase(std::ranges::unique(ids_).begin(), ids_.end());
  }

  void number(Parts parts) {
    References references;
    const auto place = [&] { return static_cast<std::uint32_t>(references.size()); };
    for_each_leaf(
        parts,
        [&](Node& leaf) {
          const std::uint32_t first = place();
          for (const std::uint32_t id : tree_.objects_of(leaf)) {
            const auto found = std::ranges::lower_bound(ids_, id);
            references.push_back(static_cast<std::uint32_t>(found - ids_.begin()));
          }
          leaf = Node::make_leaf(first, leaf.count());
        },
        [&](Node& leaf, std::uint32_t part) {
          leaf = Node::make_leaf(place(), 1);
          references.push_back(static_cast<std::uint32_t>(ids_.size()) + part);
        });
    tree_.references = std::move(references);
  }

  const Scene& scene_;
  const std::uint32_t first_part_;
  Tree tree_;
  std::vector<std::uint32_t> ids_;
  std::vector<WideObject> objects_;
};

RawVector<WideObject> wide_objects(const Scene& scene, const std::stop_token& stop) {
  RawVector<WideObject> objects;
  objects.resize(scene.objects.size());
  parallel_ranges(objects.size(), range_size, [&](std::size_t first, std::size_t last) {
    if (stop.stop_requested()) return;
    for (std::size_t i = first; i < last; ++i) {
      const auto id = static_cast<std::uint32_t>(i);
      objects[i] = wide_object(scene, id);
    }
  });
  return objects;
}

/// no_index: nothing, which no ray hits.
void set_slot(const Scene& scene, TriangleBlock& block, std::size_t slot, std::uint32_t triangle) {
  const Vec3* corners = nullptr;
  if (triangle != no_index) {
    corners = &scene.vertices[scene.faces[scene.objects[triangle].shape].first_vertex];
  }
  block.object[slot] = triangle;
  for (int vertex = 0; vertex < 3; ++vertex) {
    for (int axis = 0; axis < 3; ++axis) {
      block.vertices[vertex][axis][slot] =
          corners ? corners[vertex][axis] : std::numeric_limits<float>::quiet_NaN();
    }
  }
}

}  // namespace

/// Lays out the objects of all leaves, leaf after leaf: ranges of leaves are measured, then each
/// knows its place.
class Accelerator::LeafMaker {
 public:
  LeafMaker(const Scene& scene, const WideLeaves& leaves, Accelerator& accelerator)
      : scene_(scene), leaves_(leaves), made_(accelerator) {
    names_.resize(leaves.size());
    ranges_.resize((leaves.size() + range_size - 1) / range_size);
  }

  void make(const std::stop_token& stop) {
    parallel_ranges(leaves_.size(), range_size, [&](std::size_t first, std::size_t last) {
      Sizes& range = ranges_[first / range_size];
      for (std::size_t i = first; i < last && !stop.stop_requested(); ++i) {
        range.add(sizes_of(leaves_[i]));
      }
    });
    make_room();
    parallel_ranges(leaves_.size(), range_size, [&](std::size_t first, std::size_t last) {
      Sizes place = ranges_[first / range_size];
      for (std::size_t i = first; i < last && !stop.stop_requested(); ++i) {
        names_[i] = make_leaf(leaves_[i], place);
      }
    });
    rename(stop);
  }

 private:
  /// Of a leaf or several; or what comes before them.
  struct Sizes {
    std::size_t blocks = 0, others = 0, mixed = 0;

    void add(const Sizes& more) {
      blocks += more.blocks;
      others += more.others;
      mixed += more.mixed;
    }
  };

  /// Parts are numbered behind the objects; each is alone in its leaf.
  bool is_part(std::span<const std::uint32_t> objects) const {
    return objects.front() >= first_part();
  }

  Sizes sizes_of(std::span<const std::uint32_t> objects) const {
    if (is_part(objects)) return {};
    const auto is_one = [&](std::uint32_t id) { return is_triangle(scene_, id); };
    const auto triangles = static_cast<std::size_t>(std::ranges::count_if(objects, is_one));
    Sizes sizes{(triangles + TriangleBlock::width - 1) / TriangleBlock::width,
                objects.size() - triangles, 0};
    sizes.mixed = is_mixed(sizes.blocks, sizes.others) ? 1 : 0;
    return sizes;
  }

  /// Turns the sizes of the ranges into what comes before them.
  void make_room() {
    Sizes whole;
    for (Sizes& range : ranges_) {
      const Sizes before = whole;
      whole.add(range);
      range = before;
    }
    all_mixed_ =
        whole.blocks >= mixed_bit >> count_bits || whole.others >= others_bit >> count_bits;
    if (all_mixed_) {
      for (std::size_t i = 0; i < ranges_.size(); ++i) ranges_[i].mixed = i * range_size;
      whole.mixed = leaves_.size();
    }
    made_.blocks_.resize(whole.blocks);
    made_.others_.resize(whole.others);
    made_.mixed_.resize(whole.mixed);
  }

  /// Answers the name of the leaf, and moves `place` behind it.
  std::uint32_t make_leaf(std::span<const std::uint32_t> objects, Sizes& place) const {
    if (is_part(objects)) return part_bits | (objects.front() - first_part());
    WideLeaf leaf{static_cast<std::uint32_t>(place.blocks), 0,
                  static_cast<std::uint32_t>(place.others), 0};
    std::size_t triangles = 0;
    const auto next_slot = [&](std::uint32_t id) {
      TriangleBlock& block = made_.blocks_[leaf.first_block + triangles / TriangleBlock::width];
      set_slot(scene_, block, triangles % TriangleBlock::width, id);
      ++triangles;
    };
    for (const std::uint32_t id : objects) {
      if (is_triangle(scene_, id)) {
        next_slot(id);
      } else {
        const Object& object = scene_.objects[id];
        made_.others_[place.others++] = {id, object.shape, static_cast<std::uint32_t>(object.kind)};
      }
    }
    while (triangles % TriangleBlock::width != 0) next_slot(no_index);
    leaf.block_count = static_cast<std::uint32_t>(triangles / TriangleBlock::width);
    leaf.other_count = static_cast<std::uint32_t>(place.others) - leaf.first_other;
    place.blocks += leaf.block_count;
    if (!is_mixed(leaf.block_count, leaf.other_count)) {
      return leaf.other_count == 0
                 ? leaf.first_block << count_bits | leaf.block_count
                 : mixed_bit | others_bit | leaf.first_other << count_bits | leaf.other_count;
    }
    made_.mixed_[place.mixed] = leaf;
    return mixed_bit | static_cast<std::uint32_t>(place.mixed++);
  }

  std::uint32_t first_part() const { return static_cast<std::uint32_t>(scene_.objects.size()); }

  bool is_mixed(std::size_t blocks, std::size_t others) const {
    return all_mixed_ || (blocks > 0 && others > 0) || blocks > most_blocks || others > most_blocks;
  }

  /// The leaves of the wide tree are named by their number so far.
  void rename(const std::stop_token& stop) const {
    RawVector<WideNode>& nodes = made_.tree_.nodes;
    parallel_ranges(nodes.size(), range_size, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last && !stop.stop_requested(); ++i) {
        for (std::uint32_t& child : nodes[i].child) {
          if (child & WideNode::leaf_bit) {
            child = WideNode::leaf_bit | names_[child & ~WideNode::leaf_bit];
          }
        }
      }
    });
  }

  const Scene& scene_;
  const WideLeaves& leaves_;
  Accelerator& made_;
  bool all_mixed_ = false;          // there is more than short names can tell apart
  std::vector<Sizes> ranges_;       // of leaves: sizes, then places
  RawVector<std::uint32_t> names_;  // by leaf, without the bit of leaves
};

std::size_t Accelerator::bytes() const {
  return tree_.bytes() + blocks_.size() * sizeof(TriangleBlock) +
         others_.size() * sizeof(LeafObject) + mixed_.size() * sizeof(WideLeaf);
}

std::shared_ptr<const Accelerator> Accelerator::lay_out(
    const Scene& scene, const Tree& tree, std::vector<std::shared_ptr<const LazyPart>> parts,
    const std::stop_token& stop) {
  const Timer timer;
  LocalTree local(scene, tree, parts);
  auto widened = widen(local.tree(), local.objects(), stop);
  if (!widened) return nullptr;
  auto accelerator = std::make_shared<Accelerator>();
  accelerator->tree_ = std::move(widened->tree);
  for (std::uint32_t& object : widened->leaves.objects) object = local.name_of(object);
  LeafMaker(scene, widened->leaves, *accelerator).make(stop);
  if (stop.stop_requested()) return nullptr;
  accelerator->parts_ = std::move(parts);
  accelerator->build_seconds_ = timer.seconds();
  return accelerator;
}

Accelerator Accelerator::of_parts(const Scene& scene, std::span<const ObjectPart> parts) {
  PartBoxes boxes(scene, parts);
  Accelerator accelerator;
  accelerator.tree_.nodes = boxes.make_nodes();
  LeafMaker(scene, boxes.leaves(), accelerator).make({});
  return accelerator;
}

std::shared_ptr<const Accelerator> make_accelerator(const World& world, std::stop_token stop) {
  if (world.tree.naive) return nullptr;
  const Timer timer;
  try {
    auto accelerator = std::make_shared<Accelerator>();
    with_threads(world.tree.params.threads, [&] {
      const RawVector<WideObject> objects = wide_objects(world.scene, stop);
      const auto part = [&](std::uint32_t id, const Aabb& cell) {
        return hit_bounds(world.scene, id, objects[id].box, cell);
      };
      auto widened = widen(world.tree, {objects, part}, stop);
      if (!widened) return;
      accelerator->tree_ = std::move(widened->tree);
      Accelerator::LeafMaker(world.scene, widened->leaves, *accelerator).make(stop);
    });
    if (stop.stop_requested()) return nullptr;
    accelerator->build_seconds_ = timer.seconds();
    return accelerator;
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

}  // namespace bspview
