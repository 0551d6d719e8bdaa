#include "core/base/machine.h"

#include <fmt/format.h>

#include <fstream>

#include "core/base/parallel.h"

namespace bspview {
namespace {

std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t start = line.find_first_not_of(" \t:", line.find(':'));
    return start == std::string::npos ? "" : line.substr(start);
  }
  return "";
}

std::string widest_simd() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return "avx512";
  if (__builtin_cpu_supports("avx2")) return "avx2";
  if (__builtin_cpu_supports("avx")) return "avx";
  if (__builtin_cpu_supports("sse4.2")) return "sse4.2";
  return "sse2";
#elif defined(__aarch64__)
  return "neon";
#else
  return "none";
#endif
}

std::string compiler_name() {
#if defined(__clang__)
  return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return fmt::format("gcc {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

}  // namespace

Machine this_machine() {
  return {.cpu = cpu_name(),
          .cores = thread_count(0),
          .simd = widest_simd(),
          .compiler = compiler_name(),
          .version = BSPVIEW_VERSION};
}

}  // namespace bspview
