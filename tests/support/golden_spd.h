#pragma once

#include <string>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace bspview::test {

/// The scene as its original program wrote it: tests/golden/spd/`file`.nff.xz, unpacked by `xz`.
Result<Scene> load_golden_spd(const std::string& file);

}  // namespace bspview::test
