#include "app/viewer/panels/measure_rows.h"

#include <fmt/format.h>

#include <optional>

#include "app/viewer/panels/numbers.h"

namespace bspview {
namespace {

constexpr const char* undefined = "–";

/// What two settings must have in common for a component to be compared, and what it says.
enum class Kind { shape, cost_of_rays, cost_of_building, cost_of_picture, share_of_picture };

struct Component {
  const char* name;
  const char* symbol;
  Kind kind;
  const char* meaning;
};

constexpr Component delta_components[] = {
    {"N_LS", "N_LS", Kind::shape, "Number of leaves.\nN_LS = |L|"},
    {"R_ETNLS", "R_ETNLS", Kind::shape,
     "Ratio of empty leaves to all leaves.\nR_ETNLS = |E| / |L|"},
    {"N_ADL", "N_ADL", Kind::shape,
     "Average object duplication: in how many leaves an object is; 1 when nothing is "
     "duplicated.\nN_ADL = Σ objects in leaf / N_O"},
    {"N_AOIAL", "N_AOIAL", Kind::shape,
     "Average objects in all leaves. Derived: it follows from the others, and the paper gives it "
     "no symbol.\nN_AOIAL = Σ objects in leaf / |L| = N_AOIFL (1 − R_ETNLS)"},
    {"N_AOIFL", "N_AOIFL", Kind::shape,
     "Average objects in full leaves.\nN_AOIFL = Σ objects in leaf / |F|"},
    {"R_FVWV", "R_FVWV", Kind::shape,
     "Volume of the full leaves to the whole volume.\nR_FVWV = Σ vol(F) / vol(root)"},
    {"N_RPRT", "N_RPRT", Kind::cost_of_rays,
     "Intersection tests performed to the minimal number of tests, which is the number of rays "
     "of every kind that hit something.\nN_RPRT = tests / rays with a hit"},
    {"N_AT", "N_AT", Kind::cost_of_rays,
     "Traversed nodes per ray, leaves included, over rays of every kind.\n"
     "N_AT = (inner + leaf visits) / R"},
};

constexpr Component lambda_components[] = {
    {"T_CB", "T_CB", Kind::cost_of_building,
     "Time to construct the tree, without reading the scene."},
    {"T_TR", "T_TR", Kind::cost_of_picture,
     "Time to render the whole image with one ray a pixel, shading included, without T_CB. "
     "Measured without counters once nothing moves."},
    {"T_TT_over_T_TR", "T_TT / T_TR", Kind::share_of_picture,
     "Share of T_TR spent walking the tree, without object tests and without shading.\n"
     "How T_TT is measured: every ray of the image is recorded once; then the rays walk the tree "
     "again with the object tests left out, each through as many leaves as before, and the time "
     "to read them is taken off. Median of the repeats, ± half the distance of the quartiles."},
};

std::optional<double> value_of(const Delta& delta, std::string_view name) {
  if (name == "N_LS") return static_cast<double>(delta.n_ls);
  if (name == "R_ETNLS") return delta.r_etnls;
  if (name == "N_ADL") return delta.n_adl;
  if (name == "N_AOIAL") return delta.n_aoial;
  if (name == "N_AOIFL") return delta.n_aoifl;
  if (name == "R_FVWV") return delta.r_fvwv;
  if (name == "N_RPRT") return delta.n_rprt;
  return delta.n_at;
}

const std::optional<Measured>& value_of(const Lambda& lambda, Kind kind) {
  if (kind == Kind::cost_of_building) return lambda.t_cb;
  return kind == Kind::cost_of_picture ? lambda.t_tr : lambda.t_tt_share;
}

bool comparable(Kind kind, const Evaluation& a, const Evaluation& b) {
  const bool of_the_tree = kind == Kind::shape || kind == Kind::cost_of_building;
  return a.setting.scene == b.setting.scene && (of_the_tree || same_rays(a, b));
}

bool is_cost(Kind kind) {
  return kind != Kind::shape && kind != Kind::share_of_picture;
}

std::string delta_text(const std::optional<double>& value, std::string_view name) {
  if (!value) return undefined;
  if (name == "N_LS") return with_thousands(static_cast<std::uint64_t>(*value));
  return significant(*value, 4);
}

std::string lambda_text(const std::optional<Measured>& value, Kind kind) {
  if (!value) return undefined;
  if (kind == Kind::share_of_picture)
    return fmt::format("{:.0f} ± {:.0f} %", 100 * value->median, 100 * value->spread);
  return duration(value->median);
}

std::string repeats_text(const Measured& value, Kind kind) {
  if (value.repeats < 2) return "\nMeasured once.";
  const std::string spread = kind == Kind::share_of_picture
                                 ? fmt::format("{:.1f} %", 100 * value.spread)
                                 : duration(value.spread);
  return fmt::format("\n{} repeats, ± {}", value.repeats, spread);
}

MeasureRow make_row(const Component& component) {
  MeasureRow row{component.name, component.symbol, component.meaning};
  row.derived = component.name == std::string_view("N_AOIAL");
  return row;
}

void compare(MeasureRow& row, Kind kind, double before, double now) {
  row.change = change(before, now);
  if (is_cost(kind)) row.benefit = before - now;
}

MeasureRow delta_row(const Component& component, const Evaluation& now, const Evaluation* before) {
  MeasureRow row = make_row(component);
  const std::optional<double> value = value_of(now.delta, row.name);
  row.now = delta_text(value, row.name);
  if (before == nullptr) return row;
  const std::optional<double> old = value_of(before->delta, row.name);
  row.before = delta_text(old, row.name);
  if (value && old && comparable(component.kind, now, *before))
    compare(row, component.kind, *old, *value);
  return row;
}

MeasureRow lambda_row(const Component& component, const Evaluation& now, const Evaluation* before) {
  const Kind kind = component.kind;
  MeasureRow row = make_row(component);
  const std::optional<Measured>& value = value_of(now.lambda, kind);
  row.now = lambda_text(value, kind);
  if (value) row.meaning += repeats_text(*value, kind);
  if (before == nullptr) return row;
  const std::optional<Measured>& old = value_of(before->lambda, kind);
  row.before = lambda_text(old, kind);
  if (value && old && comparable(kind, now, *before))
    compare(row, kind, old->median, value->median);
  return row;
}

}  // namespace

std::vector<MeasureRow> delta_rows(const Evaluation& now, const Evaluation* before) {
  std::vector<MeasureRow> rows;
  for (const Component& component : delta_components)
    rows.push_back(delta_row(component, now, before));
  return rows;
}

std::vector<MeasureRow> lambda_rows(const Evaluation& now, const Evaluation* before) {
  std::vector<MeasureRow> rows;
  for (const Component& component : lambda_components)
    rows.push_back(lambda_row(component, now, before));
  return rows;
}

}  // namespace bspview
