#pragma once

// Included by everything that decides a hit: such a file must not be compiled with options that let
// the compiler change the result of an operation. Contraction (a * b + c in one rounding) makes
// neighbours disagree about the edge they share; the build defines BSPVIEW_NO_CONTRACTION together
// with the option that switches it off, for the library and for all its users, since compilers do
// not say whether it is on.

#include <cfloat>

#ifndef BSPVIEW_NO_CONTRACTION
#error "what decides hits is compiled with -ffp-contract=off -DBSPVIEW_NO_CONTRACTION: link bspview::core"
#endif
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "what decides hits is not compiled with -ffast-math or a part of it"
#endif
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "what decides hits is not compiled with -funsafe-math-optimizations or a part of it"
#endif
#if FLT_EVAL_METHOD != 0
#error "what decides hits needs float operations that are rounded to float"
#endif
