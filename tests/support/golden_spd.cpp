#include "tests/support/golden_spd.h"

#include <array>
#include <cstdio>

#include "core/scene/load.h"

namespace bspview::test {

Result<Scene> load_golden_spd(const std::string& file) {
  const std::string path = BSPVIEW_SOURCE_DIR "/tests/golden/spd/" + file + ".nff.xz";
  const std::string command = "xz --decompress --stdout '" + path + "'";
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return Error{path + ": xz could not be started"};
  std::string text;
  std::array<char, 65536> block;
  while (const std::size_t n = std::fread(block.data(), 1, block.size(), pipe)) {
    text.append(block.data(), n);
  }
  if (pclose(pipe) != 0) return Error{path + ": xz could not unpack it"};
  return parse_nff(text, file + ".nff");
}

}  // namespace bspview::test
