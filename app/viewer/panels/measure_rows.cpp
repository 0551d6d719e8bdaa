#include "app/viewer/panels/measure_rows.h"

#include <fmt/format.h>

#include <optional>

#include "app/viewer/panels/numbers.h"

namespace bspview {
namespace {

constexpr const char* undefined = "–";

/// One component: what it is and where its value is found.
struct Component {
  const char* name;
  const char* base;
  const char* index;
  const char* meaning;
  bool needs_rays;
  std::optional<double> (*value)(const Delta&);
};

const Component components[] = {
    {"N_LS", "N", "LS", "Number of leaves.\nN_LS = |L|", false,
     [](const Delta& d) { return std::optional(static_cast<double>(d.n_ls)); }},
    {"R_ETNLS", "R", "ETNLS", "Ratio of empty leaves to all leaves.\nR_ETNLS = |E| / |L|", false,
     [](const Delta& d) { return d.r_etnls; }},
    {"N_ADL", "N", "ADL",
     "Average object duplication: in how many leaves an object is; 1 when nothing is "
     "duplicated.\nN_ADL = Σ objects in leaf / N_O",
     false, [](const Delta& d) { return d.n_adl; }},
    {"N_AOIAL", "N", "AOIAL",
     "Average objects in all leaves. Derived: it follows from the others and has no symbol in "
     "the paper.\nN_AOIAL = Σ objects in leaf / |L| = N_AOIFL (1 − R_ETNLS)",
     false, [](const Delta& d) { return d.n_aoial; }},
    {"N_AOIFL", "N", "AOIFL", "Average objects in full leaves.\nN_AOIFL = Σ objects in leaf / |F|",
     false, [](const Delta& d) { return d.n_aoifl; }},
    {"R_FVWV", "R", "FVWV",
     "Volume of the full leaves to the whole volume.\nR_FVWV = Σ vol(F) / vol(root)", false,
     [](const Delta& d) { return d.r_fvwv; }},
    {"N_RPRT", "N", "RPRT",
     "Intersection tests performed to the minimal number of tests, which is the number of rays "
     "of every kind that hit something.\nN_RPRT = tests / rays that hit",
     true, [](const Delta& d) { return d.n_rprt; }},
    {"N_AT", "N", "AT",
     "Traversed nodes per ray, leaves included, over rays of every kind.\n"
     "N_AT = (inner + leaf visits) / R",
     true, [](const Delta& d) { return d.n_at; }},
};

std::string delta_text(const std::optional<double>& value, const char* name) {
  if (!value) return undefined;
  if (std::string_view(name) == "N_LS") return with_thousands(static_cast<std::uint64_t>(*value));
  return significant(*value, 4);
}

/// Fills in the comparison of two values that exist.
void compare(MeasureRow& row, double before, double now) {
  row.change = change(before, now);
  row.direction = now - before;
}

MeasureRow delta_row(const Component& c, const Evaluation& now, const Evaluation* before) {
  const std::optional<double> value = c.value(now.delta);
  MeasureRow row{c.name, c.base, c.index, c.meaning, delta_text(value, c.name), "", "", 0.0};
  if (before == nullptr) return row;
  const std::optional<double> old = c.value(before->delta);
  row.before = delta_text(old, c.name);
  const bool comparable =
      now.setting.scene == before->setting.scene && (!c.needs_rays || same_rays(now, *before));
  if (value && old && comparable) compare(row, *old, *value);
  return row;
}

struct Timing {
  const char* name;
  const char* base;
  const char* index;
  const char* meaning;
  std::optional<Measured> Lambda::*value;
};

const Timing timings[] = {
    {"T_CB", "T", "CB", "Time to construct the tree, without reading the scene.", &Lambda::t_cb},
    {"T_TR", "T", "TR",
     "Time to render the whole image with one ray a pixel, shading included, without T_CB. "
     "Measured without counters once nothing moves.",
     &Lambda::t_tr},
    {"T_TT_over_T_TR", "T", "TT / TTR",
     "Share of T_TR spent walking the tree, without object tests and shading.\n"
     "T_TT is the time that the recorded rays of the image take to walk the tree again with the "
     "object tests left out, each as far as it came, less the time to read them. Median of the "
     "repeats, ± half the distance of the quartiles.",
     &Lambda::t_tt_share},
};

std::string timing_text(const std::optional<Measured>& value, bool share) {
  if (!value) return undefined;
  if (!share) return duration(value->median);
  return fmt::format("{:.0f} ±{:.0f} %", 100 * value->median, 100 * value->spread);
}

MeasureRow lambda_row(const Timing& t, const Evaluation& now, const Evaluation* before) {
  const bool share = t.value == &Lambda::t_tt_share;
  const std::optional<Measured>& value = now.lambda.*t.value;
  MeasureRow row{t.name, t.base, t.index, t.meaning, timing_text(value, share), "", "", 0.0};
  if (value && value->repeats > 1)
    row.meaning +=
        fmt::format("\n{} repeats, ±{}", value->repeats,
                    share ? fmt::format("{:.1f} %", 100 * value->spread) : duration(value->spread));
  if (before == nullptr) return row;
  const std::optional<Measured>& old = before->lambda.*t.value;
  row.before = timing_text(old, share);
  const bool comparable = now.setting.scene == before->setting.scene &&
                          (t.value == &Lambda::t_cb || same_rays(now, *before));
  if (value && old && comparable) compare(row, old->median, value->median);
  return row;
}

}  // namespace

std::vector<MeasureRow> delta_rows(const Evaluation& now, const Evaluation* before) {
  std::vector<MeasureRow> rows;
  for (const Component& component : components) rows.push_back(delta_row(component, now, before));
  return rows;
}

std::vector<MeasureRow> lambda_rows(const Evaluation& now, const Evaluation* before) {
  std::vector<MeasureRow> rows;
  for (const Timing& timing : timings) rows.push_back(lambda_row(timing, now, before));
  return rows;
}

}  // namespace bspview
