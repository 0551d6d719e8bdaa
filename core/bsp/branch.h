#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/bsp/build_job.h"
#include "core/bsp/inner_objects.h"
#include "core/bsp/node.h"
#include "core/bsp/scratch_stack.h"

namespace bspview {

/// What one branch of the recursion writes to. A branch that runs beside another has its own and
/// is spliced in afterwards, so that the tree does not depend on who ran first.
struct Branch {
  Nodes nodes;  ///< [0] is the branch's root; children come in pairs behind parents
  References references;
  std::vector<DeferredLeaf> deferred;
  InnerLists inner;         ///< where the job keeps them
  std::size_t metered = 0;  ///< bytes that the job's meter knows of
  ScratchStack scratch;

  std::size_t bytes() const {
    return nodes.size() * sizeof(Node) + references.size() * sizeof(std::uint32_t);
  }
};

/// Puts `part` at the end and polls meanwhile: memory that is touched first takes its time.
template <class T>
void append(const BuildJob& job, RawVector<T>& whole, std::span<const T> part) {
  job.for_each(range_count(part.size()), 1, [&](std::size_t i) {
    const auto from = part.subspan(i * range_size);
    const auto some = from.first(std::min(range_size, from.size()));
    whole.insert(whole.end(), some.begin(), some.end());
  });
}

/// Makes room for `more` elements as push_back does, but polls.
template <class T>
void make_room(const BuildJob& job, RawVector<T>& elements, std::size_t more) {
  if (elements.capacity() - elements.size() >= more) return;
  RawVector<T> larger;
  larger.reserve(std::max(2 * elements.capacity(), elements.size() + more));
  append(job, larger, std::span<const T>(elements));
  elements = std::move(larger);
}

/// Tells the job's meter, if there is one, of what was added since the last time.
void meter(const BuildJob& job, Branch& branch);

/// Puts the root of `part` at `slot` of `whole`, its other nodes and its references at the end.
void splice(const BuildJob& job, Branch& whole, std::uint32_t slot, Branch& part);

}  // namespace bspview
