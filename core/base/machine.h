#pragma once

#include <string>

namespace bspview {

/// Where and by what a number was measured.
struct Machine {
  std::string cpu;       ///< name that the processor gives itself; empty: unknown
  int cores = 0;         ///< that this process may use
  std::string simd;      ///< widest vector instructions of the processor
  std::string compiler;  ///< with its version
  std::string version;   ///< of this program
  bool operator==(const Machine&) const = default;
};
Machine this_machine();

}  // namespace bspview
