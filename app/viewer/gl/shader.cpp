#include "app/viewer/gl/shader.h"

#include <string>

namespace bspview::gl {
namespace {

Result<ShaderHandle> compile(GLenum kind, const char* text) {
  ShaderHandle shader(glCreateShader(kind));
  glShaderSource(shader.get(), 1, &text, nullptr);
  glCompileShader(shader.get());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader.get(), static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return Error{"the OpenGL driver refuses a shader: " + log};
}

}  // namespace

Result<ProgramHandle> build_program(const char* vertex_text, const char* fragment_text) {
  const Result<ShaderHandle> vertex = compile(GL_VERTEX_SHADER, vertex_text);
  if (!vertex) return vertex.error();
  const Result<ShaderHandle> fragment = compile(GL_FRAGMENT_SHADER, fragment_text);
  if (!fragment) return fragment.error();
  ProgramHandle program(glCreateProgram());
  glAttachShader(program.get(), vertex->get());
  glAttachShader(program.get(), fragment->get());
  glLinkProgram(program.get());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) return Error{"the OpenGL driver cannot link a shader"};
  return program;
}

}  // namespace bspview::gl
