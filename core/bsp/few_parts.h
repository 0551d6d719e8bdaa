#pragma once

#include <array>

#include "core/bsp/build_job.h"
#include "core/bsp/few_planes.h"
#include "core/bsp/scratch_stack.h"
#include "core/shape/outline.h"

namespace bspview {

/// The objects of a node near the leaves, where most nodes are: so few that every plane is held
/// against every box, which takes no events and no sorting.
class FewParts {
 public:
  static constexpr std::size_t most = most_few_parts;

  /// None yet.
  FewParts(const BuildJob& job, ScratchStack& scratch) : job_(&job), outlines_(scratch) {}
  void push(const Aabb& box, std::uint32_t object) {
    keep({few_box(box, job_->tests_of(object)), object, {}});
  }

  std::size_t count() const { return count_; }
  /// What testing them all costs, in units of the job's C_I.
  double tests() const;
  void write_objects(std::uint32_t* to) const;
  std::optional<Split> find_split(const Place& place) const;
  FewParts split(const CellSplit& split, ScratchStack& scratch);
  void release() {}  // the outlines are those of the other side, too

 private:
  struct Part {
    FewBox box;
    std::uint32_t object;
    Outline outline;  ///< empty: not cut yet, or not to be cut by outline
  };

  /// As it is kept: without a constructor, which would run for all that there is room for.
  struct Corners {
    const OutlineCorner* first;
    std::size_t count;
  };

  Part part(std::size_t i) const {
    return {boxes_[i], objects_[i], {corners_[i].first, corners_[i].count}};
  }
  void keep(const Part& part) { keep_if(true, part); }
  /// There is room for one, kept or not.
  void keep_if(bool kept, const Part& part) {
    boxes_[count_] = part.box;
    objects_[count_] = part.object;
    corners_[count_] = {part.outline.data(), part.outline.size()};
    count_ += kept;
  }
  struct Sides {
    FewParts &left, &right;
  };
  void cut(const Part& part, const CellSplit& split, const Sides& to);
  void divide_outline(const Part& part, const CellSplit& split, Outline whole, const Sides& to);

  const BuildJob* job_;
  std::size_t count_ = 0;
  std::array<FewBox, most + 1> boxes_;
  std::array<std::uint32_t, most + 1> objects_;
  std::array<Corners, most + 1> corners_;  // none: not cut yet
  ScratchStack::Pile outlines_;            // of the parts of both children of the parent
};

}  // namespace bspview
