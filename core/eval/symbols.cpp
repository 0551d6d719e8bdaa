#include "core/eval/symbols.h"

namespace bspview {

const std::array<Symbol, delta_size>& delta_symbols() {
  static constexpr std::array<Symbol, delta_size> symbols{{
      {"N_LS", "N_LS", "leaves", "|L|, L: all leaves"},
      {"R_ETNLS", "R_ETNLS", "empty leaves / all leaves", "|E| / |L|, E: empty leaves"},
      {"N_ADL", "N_ADL", "average object duplication (1: none)",
       "Ref / N_O, Ref: sum over leaves of their objects, N_O: objects"},
      {"N_AOIAL", "-", "average objects in all leaves (derived)",
       "Ref / |L| = N_AOIFL (1 - R_ETNLS) = N_ADL N_O / N_LS"},
      {"N_AOIFL", "N_AOIFL", "average objects in full leaves", "Ref / |F|, F: full leaves"},
      {"R_FVWV", "R_FVWV", "volume of full leaves / whole volume", "sum of vol(F) / vol(root)"},
      {"N_RPRT", "N_RPRT", "intersection tests / minimal number of tests",
       "tests / rays of every kind that hit something"},
      {"N_AT", "N_AT", "traversed nodes per ray",
       "(interior + leaf visits) / R, R: rays of every kind"},
  }};
  return symbols;
}

const std::array<Symbol, lambda_size>& lambda_symbols() {
  static constexpr std::array<Symbol, lambda_size> symbols{{
      {"T_CB", "T_CB", "seconds to build the tree", "wall clock, without reading the scene"},
      {"T_TR", "T_TR", "seconds to render the image", "wall clock, shading included, without T_CB"},
      {"T_TT_over_T_TR", "T_TT / T_TR", "share of T_TR spent walking the tree",
       "T_TT: walking the tree, without object tests, without shading"},
  }};
  return symbols;
}

std::array<std::optional<double>, delta_size> values_of(const Delta& delta) {
  return {static_cast<double>(delta.n_ls),
          delta.r_etnls,
          delta.n_adl,
          delta.n_aoial,
          delta.n_aoifl,
          delta.r_fvwv,
          delta.n_rprt,
          delta.n_at};
}

std::array<std::optional<Measured>, lambda_size> values_of(const Lambda& lambda) {
  return {lambda.t_cb, lambda.t_tr, lambda.t_tt_share};
}

std::string_view traversal_time_method() {
  return "T_TT: the recorded rays walk the tree again to the same leaves without object tests; "
         "reading the rays and the root box test are timed apart and taken off";
}

}  // namespace bspview
