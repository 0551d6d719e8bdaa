#include "app/viewer/overlays/ray_table.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "core/base/counted.h"

namespace bspview {
namespace {

std::string number(double value) {
  return fmt::format("{:.4g}", value);
}

std::string visited_children(StepKind kind) {
  switch (kind) {
    case StepKind::near_only:
      return "near";
    case StepKind::far_only:
      return "far";
    case StepKind::both:
      return "near, far";
    case StepKind::leaf:
      break;
  }
  return "leaf";
}

std::string tests_in(const RayLog& log, const RayStep& step) {
  const auto tests = std::span(log.tests).subspan(step.first_test, step.test_count);
  // Of several hits the last is the nearest: each one is closer than everything before.
  const auto hit = std::find_if(tests.rbegin(), tests.rend(), [](const auto& t) { return t.hit; });
  if (hit == tests.rend()) return fmt::format("{}", tests.size());
  return fmt::format("{}, hits object {} at {}", tests.size(), hit->object, number(hit->t));
}

RayTableRow make_row(const RayLog& log, std::size_t index) {
  const RayStep& step = log.steps[index];
  RayTableRow row;
  row.step = fmt::format("{}", index + 1);
  row.node = fmt::format("{}", step.node);
  row.visits = visited_children(step.kind);
  row.interval = fmt::format("{} to {}", number(step.t_enter), number(step.t_exit));
  if (step.kind == StepKind::leaf) {
    row.tests = tests_in(log, step);
    return row;
  }
  row.split = fmt::format("{} = {}", "xyz"[step.axis], number(step.split));
  row.t_split = std::isfinite(step.t_split) ? number(step.t_split) : "never";
  return row;
}

std::string_view name_of(RayKind kind) {
  switch (kind) {
    case RayKind::primary:
      return "eye ray";
    case RayKind::reflected:
      return "reflected ray";
    case RayKind::refracted:
      return "refracted ray";
    case RayKind::shadow:
      break;
  }
  return "shadow ray";
}

std::string fate_of(const PathRay& ray) {
  const bool shadow = ray.kind == RayKind::shadow;
  if (ray.object == no_index) return shadow ? "reaches the light" : "leaves the scene";
  return fmt::format("{} object {} at t = {}", shadow ? "is blocked by" : "hits", ray.object,
                     number(ray.t));
}

}  // namespace

std::vector<RayTableRow> ray_table(const PathRay& ray) {
  std::vector<RayTableRow> rows;
  rows.reserve(ray.log.steps.size());
  for (std::size_t i = 0; i < ray.log.steps.size(); ++i) rows.push_back(make_row(ray.log, i));
  return rows;
}

std::string ray_title(const PathRay& ray, int index) {
  const std::string sender = ray.parent < 0 ? "" : fmt::format(" of ray {}", ray.parent + 1);
  return fmt::format("{} {}{}: {}", index + 1, name_of(ray.kind), sender, fate_of(ray));
}

std::string ray_summary(const PathRay& ray) {
  const auto& steps = ray.log.steps;
  const auto leaves = std::count_if(
      steps.begin(), steps.end(), [](const RayStep& step) { return step.kind == StepKind::leaf; });
  return fmt::format("{}, {}, {}", counted(steps.size(), "step"),
                     counted(static_cast<std::uint64_t>(leaves), "leaf", "leaves"),
                     counted(ray.log.tests.size(), "test"));
}

}  // namespace bspview
