#pragma once

namespace bspview::shader_text {

/// The files of shaders/, embedded when the project is configured.
extern const char* const viewport_vert;
extern const char* const picture_frag;

}  // namespace bspview::shader_text
