#pragma once

#include "app/viewer/gl/handle.h"
#include "core/base/result.h"

namespace bspview::gl {

/// Compiles and links; the error is the driver's.
Result<ProgramHandle> build_program(const char* vertex_text, const char* fragment_text);

}  // namespace bspview::gl
