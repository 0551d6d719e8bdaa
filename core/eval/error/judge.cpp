#include "core/eval/error/judge.h"

#include <algorithm>
#include <mutex>

#include "core/base/parallel.h"

namespace bspview {
namespace {

constexpr std::size_t rays_a_chunk = 512;

/// Answers of every kernel to a piece of a batch.
struct Answers {
  std::vector<std::vector<RayResult>> closest;  // by kernel
  std::vector<std::vector<char>> occluded;
};

Answers answer(std::span<const BoundKernel> kernels, RayGroup group, std::span<const Ray> rays) {
  Answers answers;
  for (const BoundKernel& bound : kernels) {
    if (!bound.closest) {
      answers.closest.emplace_back();
      answers.occluded.emplace_back();
    } else if (group == RayGroup::shadow) {
      bound.occluded(rays, answers.occluded.emplace_back(rays.size()));
    } else {
      bound.closest(rays, answers.closest.emplace_back(rays.size()));
    }
  }
  return answers;
}

/// Judgements on one ray, each asked for once.
class RayJudge {
 public:
  RayJudge(const JudgedScene& scene, const Ray& ray)
      : scene_(scene), reference_(scene.reference), ray_(ray) {}

  const Judgement& closest(const RayResult& answer) {
    for (const auto& [known, judgement] : known_) {
      if (known == answer) return judgement;
    }
    known_.emplace_back(answer, reference_.judge(ray_, answer.object, answer.t));
    return known_.back().second;
  }
  Verdict occluded(bool hit) {
    auto& verdict = hit ? when_hit_ : when_free_;
    if (!verdict) verdict = reference_.judge_any(ray_, hit);
    return *verdict;
  }
  bool leaks() {
    if (!leaks_) leaks_ = leaks_at(scene_, ray_);
    return *leaks_;
  }

 private:
  const JudgedScene& scene_;
  const Reference& reference_;
  const Ray& ray_;
  std::vector<std::pair<RayResult, Judgement>> known_;
  std::optional<Verdict> when_hit_, when_free_;
  std::optional<bool> leaks_;
};

bool sees_front(const Scene& scene, std::uint32_t triangle, const Ray& ray) {
  const auto corners = vertices_of(scene, scene.faces[scene.objects[triangle].shape]);
  const Vec3d normal = triangle_normal(corners[0], corners[1], corners[2]);
  return glm::dot(normal, Vec3d(ray.direction)) < 0.0;
}

std::vector<ErrorCounts> judge_chunk(const JudgedScene& scene, std::span<const BoundKernel> kernels,
                                     RayGroup group, std::span<const Ray> rays) {
  const Answers answers = answer(kernels, group, rays);
  std::vector<ErrorCounts> counts(kernels.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RayJudge judge(scene, rays[i]);
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      if (!kernels[k].closest) continue;
      HitCounts& hits = counts[k].hits[static_cast<std::size_t>(group)];
      if (group == RayGroup::shadow) {
        hits.add(judge.occluded(answers.occluded[k][i] != 0));
        continue;
      }
      const RayResult& result = answers.closest[k][i];
      const Judgement& judgement = judge.closest(result);
      hits.add(judgement.verdict);
      hits.leaks += judgement.verdict == Verdict::lost && is_aimed(group) && judge.leaks();
      const bool is_right_hit = judgement.verdict == Verdict::right && result.object != no_index;
      if (is_right_hit) counts[k].t_error.add(judgement.t_error);
    }
  }
  return counts;
}

}  // namespace

BoundKernel::BoundKernel(const ErrorConfig& config, const World& world)
    : closest(config.kernel.closest(world)), occluded(config.kernel.occluded(world)) {
  if (config.choice) offset = config.choice->offset;
}

bool leaks_at(const JudgedScene& scene, const Ray& ray) {
  constexpr double rim = 1e-3;  // of the triangle's size
  const Scene& objects = scene.world.scene;
  const std::vector<Candidate> met = scene.reference.meetings(ray);
  if (met.empty()) return false;
  const Vec3 size = object_bounds(objects, met.front().object).extent();
  const double depth = rim * largest_component(size) / glm::length(Vec3d(ray.direction));
  int passages = 0;
  bool on_border = false;  // objects that share one are passed together
  bool enters = false, leaves = false;
  for (const Candidate& one : met) {
    if (one.hit.t > met.front().hit.t + depth) break;
    if (one.hit.meeting == Meeting::interior) ++passages;
    on_border |= one.hit.meeting == Meeting::border;
    (sees_front(objects, one.object, ray) ? enters : leaves) = true;
  }
  return (passages + on_border) % 2 == 1 && !(enters && leaves);
}

std::vector<ErrorCounts> judge_hits(const JudgedScene& scene, std::span<const BoundKernel> kernels,
                                    const Watch& watch) {
  struct Chunk {
    RayGroup group;
    std::span<const Ray> rays;
  };
  std::vector<Chunk> chunks;
  for (const RayBatch& batch : scene.batches) {
    const std::span rays(batch.rays);
    for (std::size_t first = 0; first < rays.size(); first += rays_a_chunk) {
      const std::size_t size = std::min(rays_a_chunk, rays.size() - first);
      chunks.push_back({batch.group, rays.subspan(first, size)});
    }
  }
  std::vector<ErrorCounts> sums(kernels.size());
  std::mutex mutex;
  with_threads(scene.threads, [&] {
    parallel_for(static_cast<int>(chunks.size()), [&](int index) {
      if (watch.stopped()) return;
      const Chunk& chunk = chunks[static_cast<std::size_t>(index)];
      const auto counts = judge_chunk(scene, kernels, chunk.group, chunk.rays);
      const std::lock_guard lock(mutex);  // integers and maxima: the order does not matter
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += counts[k];
      watch.advance(static_cast<double>(chunk.rays.size()));
    });
  });
  return sums;
}

}  // namespace bspview
