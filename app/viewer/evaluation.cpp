#include "app/viewer/evaluation.h"

namespace bspview {

bool same_rays(const Evaluation& a, const Evaluation& b) {
  return a.view && b.view && a.setting.scene == b.setting.scene &&
         a.view->camera == b.view->camera && a.view->params.width == b.view->params.width &&
         a.view->params.height == b.view->params.height &&
         a.view->params.max_ray_depth == b.view->params.max_ray_depth &&
         a.view->params.cutoff == b.view->params.cutoff;
}

Evaluation evaluate(const BuiltTree& tree, const Picture* picture, const Measures* measures) {
  Evaluation result;
  result.setting = tree.request;
  result.origin = tree.origin;
  const std::size_t objects = tree.tree.object_count;
  if (picture != nullptr && picture->counted && picture->request.tree.get() == &tree) {
    result.view = picture->request;
    result.rays = picture->counts;
    result.delta = compute_delta(tree.stats, objects, picture->counts);
  } else {
    result.delta = compute_delta(tree.stats, objects);
  }
  if (measures != nullptr && measures->request.tree.get() == &tree)
    result.lambda = measures->lambda;
  if (tree.origin == BuiltTree::Origin::build)
    result.lambda.t_cb = Measured{tree.tree.build_seconds, 0.0, 1};
  return result;
}

}  // namespace bspview
