#include "app/viewer/state.h"

namespace bspview {

void open_source(State& state, const std::string& source) {
  state.source = state.source_text = source;
  state.notice.clear();
  ++state.load_attempt;
}

}  // namespace bspview
