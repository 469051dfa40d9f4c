#include "kiosk/picture/render/calls.h"

namespace onggi::render::calls {
namespace {

thread_local FrameWork work;

constexpr GLenum kCounted[] = {GL_VERTEX_SHADER_INVOCATIONS_ARB,
                               GL_FRAGMENT_SHADER_INVOCATIONS_ARB};

std::size_t texel_bytes(GLenum format, GLenum type) {
  const std::size_t channels = format == GL_RED || format == GL_RED_INTEGER ? 1
                               : format == GL_RG                            ? 2
                               : format == GL_RGB                           ? 3
                                                                            : 4;
  return channels * (type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : 4);
}

std::size_t area(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

const FrameWork& so_far() { return work; }

void use_program(GLuint name) {
  ++work.switches;
  glUseProgram(name);
}

void bind_array(GLuint name) {
  ++work.switches;
  glBindVertexArray(name);
}

void bind_framebuffer(GLenum target, GLuint name) {
  ++work.switches;
  glBindFramebuffer(target, name);
}

void bind_texture(int unit, GLuint name) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  bind_texture(name);
}

void bind_texture(GLuint name) {
  ++work.switches;
  glBindTexture(GL_TEXTURE_2D, name);
}

void bind_samples(int unit, GLuint name) {
  ++work.switches;
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, name);
}

void draw_elements(GLenum mode, GLsizei count, GLenum type, std::size_t first) {
  ++work.draws;
  work.vertices += static_cast<std::uint64_t>(count);
  const std::size_t size = type == GL_UNSIGNED_SHORT ? 2 : 4;
  glDrawElements(mode, count, type, reinterpret_cast<const void*>(first * size));
}

void draw_elements_times(GLenum mode, GLsizei count, GLenum type, GLsizei times) {
  ++work.draws;
  work.vertices += static_cast<std::uint64_t>(count) * static_cast<std::uint64_t>(times);
  glDrawElementsInstanced(mode, count, type, nullptr, times);
}

void buffer_data(GLenum target, std::size_t bytes, const void* data, GLenum usage) {
  if (data != nullptr) work.bytes += bytes;
  glBufferData(target, static_cast<GLsizeiptr>(bytes), data, usage);
}

void buffer_part(GLenum target, std::size_t offset, std::size_t bytes, const void* data) {
  work.bytes += bytes;
  glBufferSubData(target, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

void texture_image(GLint level, GLint internal, int width, int height, GLenum format, GLenum type,
                   const void* pixels) {
  if (pixels != nullptr) work.bytes += area(width, height) * texel_bytes(format, type);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, level, internal, width, height, 0, format, type, pixels);
}

void texture_part(int x, int y, int width, int height, GLenum format, GLenum type,
                  const void* pixels, int row_length, int level) {
  work.bytes += area(width, height) * texel_bytes(format, type);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, row_length);
  glTexSubImage2D(GL_TEXTURE_2D, level, x, y, width, height, format, type, pixels);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void texture_samples(int samples, GLint internal, int width, int height) {
  if (epoxy_is_desktop_gl())
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, static_cast<GLenum>(internal),
                            width, height, GL_TRUE);
  else
    glTexStorage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, static_cast<GLenum>(internal),
                              width, height, GL_TRUE);
}

void copy(int x, int y, int width, int height) {
  if (width < 1 || height < 1) return;
  work.copied += area(width, height);
  glBlitFramebuffer(x, y, x + width, y + height, x, y, x + width, y + height, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
}

void copy_depth(int x, int y, int width, int height) {
  if (width < 1 || height < 1) return;
  work.copied += area(width, height);
  glBlitFramebuffer(x, y, x + width, y + height, x, y, x + width, y + height,
                    GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_NEAREST);
}

bool Shading::counted() { return epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query"); }

Shading::Shading(bool on) {
  if (!on || !counted()) return;
  glGenQueries(2, queries_);
  for (std::size_t i = 0; i < 2; ++i) glBeginQuery(kCounted[i], queries_[i]);
}

Shading::~Shading() {
  if (queries_[0] == 0) return;
  GLuint64 runs[2] = {};
  for (std::size_t i = 0; i < 2; ++i) {
    glEndQuery(kCounted[i]);
    glGetQueryObjectui64v(queries_[i], GL_QUERY_RESULT, &runs[i]);
  }
  glDeleteQueries(2, queries_);
  work.vertex_runs += runs[0];
  work.fragment_runs += runs[1];
}

}  // namespace onggi::render::calls
