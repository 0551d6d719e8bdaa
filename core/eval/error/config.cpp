#include "core/eval/error/config.h"

#include <fmt/format.h>

#include <algorithm>

namespace bspview {
namespace {

constexpr std::array<std::string_view, factor_count> factor_names{"faces", "traversal", "tree",
                                                                  "quadrics", "offset"};

int& level(Levels& levels, Factor factor) {
  return levels[static_cast<std::size_t>(factor)];
}
int level(const Levels& levels, Factor factor) {
  return levels[static_cast<std::size_t>(factor)];
}

/// What a level is a level of, where its name does not say it.
std::string_view suffix_of(Factor factor) {
  switch (factor) {
    case Factor::faces:
      return " faces";
    case Factor::quadrics:
      return " quadrics";
    case Factor::tree:
      return " tree";
    case Factor::offset:
    case Factor::traversal:
      break;
  }
  return "";
}

/// Every index below `counts`, one after the other; `levels` starts with all the least.
bool next_combination(Levels& levels, std::span<const Factor> factors, const ErrorDesign& design) {
  for (const Factor factor : factors) {
    if (++level(levels, factor) < design.level_count(factor)) return true;
    level(levels, factor) = 0;
  }
  return false;
}

}  // namespace

std::string_view name_of(Factor factor) {
  return factor_names[static_cast<std::size_t>(factor)];
}

ErrorDesign::ErrorDesign(Traversal own_traversal, Builder own_builder) {
  builders_ = {own_builder};
  for (const Builder other : {Builder::sah, Builder::median}) {
    if (std::ranges::find(builders_, other) == builders_.end()) builders_.push_back(other);
  }
  const KernelChoice own;
  accurate_ = {static_cast<int>(own.faces), static_cast<int>(own_traversal), 0,
               static_cast<int>(own.quadrics), static_cast<int>(own.offset)};
  fast_ = {static_cast<int>(FaceTest::moeller_float), static_cast<int>(Traversal::havran), 0,
           static_cast<int>(QuadricTest::textbook_float), static_cast<int>(OffsetRule::fixed)};
}

int ErrorDesign::level_count(Factor factor) const {
  switch (factor) {
    case Factor::faces:
      return static_cast<int>(face_test_names().size());
    case Factor::traversal:
      return static_cast<int>(traversal_names().size());
    case Factor::tree:
      return static_cast<int>(builders_.size());
    case Factor::quadrics:
      return static_cast<int>(quadric_test_names().size());
    case Factor::offset:
      break;
  }
  return static_cast<int>(offset_rule_names().size());
}

std::string_view ErrorDesign::level_name(Factor factor, int index) const {
  const auto i = static_cast<std::size_t>(index);
  switch (factor) {
    case Factor::faces:
      return face_test_names()[i];
    case Factor::traversal:
      return traversal_names()[i];
    case Factor::tree:
      return name_of(builders_[i]);
    case Factor::quadrics:
      return quadric_test_names()[i];
    case Factor::offset:
      break;
  }
  return offset_rule_names()[i];
}

std::vector<Levels> ErrorDesign::one_at_a_time() const {
  std::vector<Levels> all{fast_, accurate_};
  for (const Levels& anchor : {fast_, accurate_}) {
    for (std::size_t f = 0; f < factor_count; ++f) {
      const auto factor = static_cast<Factor>(f);
      for (int i = 0; i < level_count(factor); ++i) {
        Levels changed = anchor;
        changed[f] = i;
        add_levels(all, std::span(&changed, 1));
      }
    }
  }
  return all;
}

std::vector<Levels> ErrorDesign::combinations(std::span<const Factor> factors) const {
  Levels levels = accurate_;
  for (const Factor factor : factors) level(levels, factor) = 0;
  std::vector<Levels> all{levels};
  while (next_combination(levels, factors, *this)) all.push_back(levels);
  return all;
}

std::string ErrorDesign::short_name(const Levels& levels) const {
  const auto changes = [&](const Levels& anchor) {
    std::vector<std::string> names;
    for (std::size_t f = 0; f < factor_count; ++f) {
      if (levels[f] == anchor[f]) continue;
      const auto factor = static_cast<Factor>(f);
      names.push_back(fmt::format("{}{}", level_name(factor, levels[f]), suffix_of(factor)));
    }
    return names;
  };
  const std::vector<std::string> from_fast = changes(fast_), from_default = changes(accurate_);
  const bool is_fast = from_fast.size() < from_default.size();
  std::string name = is_fast ? "fast" : "default";
  for (const std::string& change : is_fast ? from_fast : from_default) name += " + " + change;
  return name;
}

ErrorConfig ErrorDesign::config(const Levels& levels) const {
  const KernelChoice choice{static_cast<FaceTest>(level(levels, Factor::faces)),
                            static_cast<QuadricTest>(level(levels, Factor::quadrics)),
                            static_cast<Traversal>(level(levels, Factor::traversal)),
                            static_cast<OffsetRule>(level(levels, Factor::offset))};
  ErrorConfig config;
  config.kernel = make_kernel(choice);
  config.choice = choice;
  config.builder = builders_[static_cast<std::size_t>(level(levels, Factor::tree))];
  config.what = fmt::format("{}, tree {}", config.kernel.what, name_of(config.builder));

  config.name = short_name(levels);
  return config;
}

std::optional<Factor> only_difference(const Levels& a, const Levels& b) {
  std::optional<Factor> found;
  for (std::size_t f = 0; f < factor_count; ++f) {
    if (a[f] == b[f]) continue;
    if (found) return std::nullopt;
    found = static_cast<Factor>(f);
  }
  return found;
}

void add_levels(std::vector<Levels>& all, std::span<const Levels> more) {
  for (const Levels& levels : more) {
    if (std::ranges::find(all, levels) == all.end()) all.push_back(levels);
  }
}

}  // namespace bspview
