// Wrong walks through the tree.

#include "core/render/intersect.h"
#include "tests/mutants/mutants.h"

namespace bspview::test {
namespace {

using stress::Subject;

/// How the ray's interval in the root box is found.
using RootRule = RayInterval (*)(const Tree& tree, const RayWalk& ray);

/// A slab test that does not look for NaN.
RayInterval naive_interval(const Tree& tree, const RayWalk& ray) {
  RayInterval interval{ray.t_min, ray.t_max};
  for (int axis = 0; axis < 3; ++axis) {
    const float a = (tree.box.lo[axis] - ray.origin[axis]) * ray.inverse[axis];
    const float b = (tree.box.hi[axis] - ray.origin[axis]) * ray.inverse[axis];
    interval.enter = std::max(std::min(a, b), interval.enter);
    interval.exit = std::min(std::max(a, b), interval.exit);
  }
  return interval;
}

void keep_nearer(const World& world, const RayQuery& query, std::uint32_t id, Hit& best) {
  const double t = hit_object(world.scene, id, query, SideRule::two_sided);
  const bool nearer = t < best.t || (t == best.t && id < best.object);
  if (nearer && t != no_hit) best = {t, id, no_leaf};
}

/// Pharr & Humphreys' form of the walk: the distance of a plane is taken at face value. Calls
/// leaf(node, exit) for the leaves along the ray until it answers true.
template <class Leaf>
void walk(const Tree& tree, const RayWalk& ray, RootRule root, const Leaf& leaf) {
  RayInterval interval = root(tree, ray);
  if (!(interval.enter <= interval.exit)) return;
  WalkStack stack;
  std::uint32_t index = 0;
  for (;;) {
    const Node node = tree.nodes[index];
    if (node.is_leaf()) {
      if (leaf(node, interval.exit) || stack.empty()) return;
      const auto next = stack.pop();
      index = next.node;
      interval = next.interval;
      continue;
    }
    const int axis = node.axis();
    const float t = ray.plane_distance(node);
    const bool below = ray.origin[axis] < node.split() ||
                       (ray.origin[axis] == node.split() && ray.direction[axis] <= 0.0f);
    const NearFar child = near_far(node, below);
    if (t > interval.exit || t <= 0.0f) {
      index = child.near;
    } else if (t < interval.enter) {
      index = child.far;
    } else {
      stack.push(child.far, {t, interval.exit});
      interval.exit = t;
      index = child.near;
    }
  }
}

template <RootRule root>
Hit closest(const World& world, const Ray& ray, RayCost& cost) {
  const RayWalk walking(ray);
  const RayQuery query = ExactShapes::query(world, ray);
  Hit best;
  walk(world.tree, walking, root, [&](const Node& node, float exit) {
    ++cost.leaves;
    for (const std::uint32_t id : world.tree.objects_of(node)) keep_nearer(world, query, id, best);
    return best.t <= exit * walking.scale;
  });
  return best;
}

/// Tests every object of every leaf; a hit counts where its point lies inside the cell.
void visit_cell(const World& world, const RayQuery& query, std::pair<std::uint32_t, Aabb> place,
                Hit& best) {
  const auto& [index, cell] = place;
  const Node node = world.tree.nodes[index];
  if (!node.is_leaf()) {
    const Cells cells = split_cell(cell, node.axis(), node.split());
    visit_cell(world, query, {node.left(), cells.left}, best);
    visit_cell(world, query, {node.right(), cells.right}, best);
    return;
  }
  for (const std::uint32_t id : world.tree.objects_of(node)) {
    Hit hit = best;
    keep_nearer(world, query, id, hit);
    const Vec3 point = query.origin + static_cast<float>(hit.t) * query.direction;
    if (cell.contains(point)) best = hit;
  }
}

template <Traversal traversal>
Subject with_traversal() {
  Subject subject = stress::default_subject();
  subject.closest = [](const World& world, const Ray& ray, RayCost& cost) {
    CountObserver count(cost);
    return closest_hit(world, ray, {.traversal = traversal}, count);
  };
  subject.occluded = [](const World& world, const Ray& ray) {
    NoObserver none;
    return any_hit(world, ray, {.traversal = traversal}, none) != no_index;
  };
  return subject;
}

}  // namespace

Subject single_distances() {
  Subject subject = stress::default_subject();
  subject.closest = closest<root_interval>;
  return subject;
}

Subject hits_inside_cells() {
  Subject subject = stress::default_subject();
  subject.closest = [](const World& world, const Ray& ray, RayCost&) {
    Hit best;
    visit_cell(world, ExactShapes::query(world, ray), {0, world.tree.box}, best);
    return best;
  };
  return subject;
}

Subject naive_slabs() {
  Subject subject = stress::default_subject();
  subject.closest = closest<naive_interval>;
  return subject;
}

Subject short_sighted_occlusion() {
  Subject subject = stress::default_subject();
  subject.occluded = [](const World& world, const Ray& ray) {
    const RayQuery query = ExactShapes::query(world, ray);
    bool hit = false;
    walk(world.tree, RayWalk(ray), root_interval, [&](const Node& node, float) {
      for (const std::uint32_t id : world.tree.objects_of(node)) {
        hit |= hit_object(world.scene, id, query, SideRule::two_sided) != no_hit;
      }
      return true;
    });
    return hit;
  };
  return subject;
}

Subject published(Traversal traversal) {
  return traversal == Traversal::havran ? with_traversal<Traversal::havran>()
                                        : with_traversal<Traversal::sung_shirley>();
}

}  // namespace bspview::test
