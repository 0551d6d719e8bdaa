#version 330 core

// One triangle that covers the whole viewport; needs no vertex buffer.
out vec2 uv;  // (0, 0) at the top left, as in the picture

void main() {
  vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  uv = vec2(corner.x, 1.0 - corner.y);
  gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
