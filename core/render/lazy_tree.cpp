#include "core/render/lazy_tree.h"

#include <new>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/render/lazy_graft.h"

namespace bspview {
Result<std::shared_ptr<const LazyTree>> LazyTree::build(const Scene& scene,
                                                        const BuildParams& params,
                                                        std::stop_token stop) {
  const Timer timer;
  try {
    std::shared_ptr<LazyTree> lazy;
    with_threads(params.threads, [&] { lazy.reset(new LazyTree(scene, stop)); });
    auto top = build_partial_tree(lazy->objects_.input(), params, stop);
    if (!top) return top.error();
    lazy->bytes_ = top->tree.bytes();
    lazy->memory_limit_reached_ = top->tree.memory_limit_reached;
    with_threads(params.threads, [&] { lazy->accelerator_ = lazy->lay_out(*top, stop); });
    if (!lazy->accelerator_) return Error{"stopped"};
    lazy->top_ = std::move(top->tree);
    lazy->seconds_ = timer.seconds();
    return std::shared_ptr<const LazyTree>(lazy);
  } catch (const std::bad_alloc&) {
    return Error{"not enough memory for the tree"};
  }
}

std::shared_ptr<const Accelerator> LazyTree::lay_out(PartialTree& part,
                                                     std::stop_token stop) const {
  std::vector<std::shared_ptr<const LazyPart>> parts;
  parts.reserve(part.deferred.size());
  for (DeferredLeaf& leaf : part.deferred) {
    parts.push_back(std::make_shared<const LazyPart>(*this, std::move(leaf)));
  }
  return Accelerator::lay_out(scene_, part.tree, std::move(parts), stop);
}

std::shared_ptr<const Accelerator> LazyTree::grow(const DeferredLeaf& leaf, Tree& tree) const {
  const Timer timer;
  try {
    auto part = build_deferred(objects_.input(), top_, leaf, memory_left());
    if (part) {
      std::shared_ptr<const Accelerator> below;
      with_threads(1, [&] { below = lay_out(*part, {}); });
      if (part->tree.memory_limit_reached) memory_limit_reached_ = true;
      bytes_ += part->tree.bytes();
      tree = std::move(part->tree);
      part_seconds_ += timer.seconds();
      return below;
    }
  } catch (const std::bad_alloc&) {
  }
  memory_limit_reached_ = true;
  return nullptr;
}

std::size_t LazyTree::memory_left() const {
  const std::size_t limit = top_.params.memory_limit, used = bytes_;
  return limit > used ? limit - used : 0;
}

Result<Tree> LazyTree::graft() const {
  try {
    Tree tree = graft_parts(top_, accelerator_->parts());
    tree.memory_limit_reached = memory_limit_reached_;
    tree.build_seconds = seconds_ - accelerator_->build_seconds() + part_seconds_;
    return tree;
  } catch (const std::bad_alloc&) {
    return Error{"not enough memory for the tree"};
  }
}

}  // namespace bspview
