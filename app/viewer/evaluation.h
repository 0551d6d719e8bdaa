#pragma once

#include <optional>

#include "app/viewer/requests.h"
#include "core/eval/delta.h"

namespace bspview {

/// The numbers of one setting, as far as they are known.
struct Evaluation {
  TreeRequest setting;
  BuiltTree::Origin origin = BuiltTree::Origin::build;
  std::optional<PictureRequest> view;  ///< whose rays were counted
  std::optional<RayCounts> rays;
  Delta delta;
  Lambda lambda;
};

/// Whether the rays of both are the same ones, so that what they cost can be compared.
bool same_rays(const Evaluation& a, const Evaluation& b);

/// What `picture` and `measures` say of `tree`; either may be missing or of another tree.
Evaluation evaluate(const BuiltTree& tree, const Picture* picture, const Measures* measures);

/// Keeps the numbers of the previous setting beside those of the current one.
class Comparison {
 public:
  /// Call before a setting changes: what is known now, of more than a sketch, becomes the previous
  /// setting's.
  void begin_edit() {
    if (now_ && now_->rays && now_->origin != BuiltTree::Origin::sketch) before_ = now_;
  }
  void update(const Evaluation& now) { now_ = now; }

  const std::optional<Evaluation>& now() const { return now_; }
  const std::optional<Evaluation>& before() const { return before_; }

 private:
  std::optional<Evaluation> now_, before_;
};

}  // namespace bspview
