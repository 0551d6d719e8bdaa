// The cheapest of all planes (see event_sweep.cpp and few_planes.cpp).

#include "core/bsp/event_sweep.h"
#include "core/bsp/recursion.h"
#include "core/bsp/split_rules.h"

namespace bspview {
namespace {

class SweptObjects {
 public:
  SweptObjects(const BuildJob& job, EventList events) : job_(&job), events_(std::move(events)) {}

  std::size_t count() const { return events_.count(); }
  void write_objects(std::uint32_t* to) const { events_.write_objects(to); }

  std::optional<Split> find_split(const Place& place) const {
    const Split best = cheapest_of_events(*job_, events_, place.cell);
    return std::isfinite(best.tests) ? std::optional(best) : std::nullopt;
  }

  FewParts few_parts(ScratchStack& scratch) const { return events_.few_parts(scratch); }

  SweptObjects split(const CellSplit& split, ScratchStack& scratch) {
    return SweptObjects(*job_, events_.split(split, scratch));
  }
  void release() { events_.release(); }

 private:
  const BuildJob* job_;
  EventList events_;
};

}  // namespace

void grow_sah(const BuildJob& job, ObjectParts parts, Branch& branch) {
  SweptObjects objects(job, EventList(job, parts, branch.scratch));
  parts = {};
  Recursion<SweptObjects>(job).grow_root(objects, branch);
}

}  // namespace bspview
