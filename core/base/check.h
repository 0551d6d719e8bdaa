#pragma once

#include <cstdio>
#include <cstdlib>

/// Ends the program when `condition`, which only a bug of ours can break, does not hold.
/// On in every build.
#define BSPVIEW_CHECK(condition)                                                        \
  do {                                                                                  \
    if (!(condition)) {                                                                 \
      std::fprintf(stderr, "%s:%d: check failed: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                     \
    }                                                                                   \
  } while (false)
