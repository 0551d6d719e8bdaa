// On x86 this file is compiled for processors with FMA and with contraction on, and must run on
// such a processor; elsewhere the fused operation is written out. The arithmetic is the same.

#include <cmath>

#include "tests/mutants/mutants.h"

namespace bspview::test {

float contracted_edge(Vec2 p, Vec2 q) {
#ifdef BSPVIEW_MUTANT_CONTRACTED_BY_COMPILER
  return p.x * q.y - p.y * q.x;
#else
  return std::fma(p.x, q.y, -(p.y * q.x));
#endif
}

}  // namespace bspview::test
