#pragma once

#include <epoxy/gl.h>

#include <glm/ext/scalar_constants.hpp>
#include <glm/glm.hpp>
#include <initializer_list>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/math/vec.h"
#include "kiosk/picture/render/calls.h"

namespace onggi::render {

/// True with OpenGL ES 3.1, if the driver has no OpenGL 3.3 (window.cpp). ES has less: it does not
/// filter 32-bit floats and 16-bit shares, so shaders do (common.glsl); sRGB without alpha has no
/// mipmap levels; float targets and GL_SAMPLE_ALPHA_TO_ONE need extensions.
inline bool embedded() { return !epoxy_is_desktop_gl(); }

/// Converts to GL's type.
inline glm::vec3 vec(Vec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Owns a GL name. The context must be current when it is destroyed.
template <void (*Delete)(GLuint)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint name) : name_(name) {}
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~Handle() {
    if (name_ != 0) Delete(name_);
  }
  GLuint get() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  GLuint name_ = 0;
};

inline void delete_texture(GLuint name) { glDeleteTextures(1, &name); }
inline void delete_buffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void delete_array(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void delete_framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void delete_renderbuffer(GLuint name) { glDeleteRenderbuffers(1, &name); }
inline void delete_program(GLuint name) { glDeleteProgram(name); }

using TextureName = Handle<delete_texture>;
using BufferName = Handle<delete_buffer>;
using ArrayName = Handle<delete_array>;
using FramebufferName = Handle<delete_framebuffer>;
using RenderbufferName = Handle<delete_renderbuffer>;
using ProgramName = Handle<delete_program>;

/// A linked pair of stages. Call use() before set().
class Program {
 public:
  /// `parts` are joined in order for both stages. Problem: the compiler's log, exit code 1.
  static Result<Program> create(const std::string& name, std::initializer_list<const char*> parts);
  void use() const { calls::use_program(name_.get()); }
  explicit operator bool() const { return static_cast<bool>(name_); }
  void set(const char* uniform, int value) const { glUniform1i(at(uniform), value); }
  void set(const char* uniform, float value) const { glUniform1f(at(uniform), value); }
  void set(const char* uniform, glm::vec2 v) const { glUniform2f(at(uniform), v.x, v.y); }
  void set(const char* uniform, glm::vec3 v) const { glUniform3f(at(uniform), v.x, v.y, v.z); }
  void set(const char* uniform, glm::vec4 v) const { glUniform4f(at(uniform), v.x, v.y, v.z, v.w); }
  void set(const char* uniform, const glm::mat3& m) const {
    glUniformMatrix3fv(at(uniform), 1, GL_FALSE, &m[0][0]);
  }
  void set(const char* uniform, const glm::mat4& m) const {
    glUniformMatrix4fv(at(uniform), 1, GL_FALSE, &m[0][0]);
  }
  void set(const char* uniform, const glm::vec3* v, int count) const {
    glUniform3fv(at(uniform), count, &v[0][0]);
  }

 private:
  GLint at(const char* uniform) const;
  ProgramName name_;
  mutable std::unordered_map<std::string, GLint> places_;
};

/// A texture with its size. Filters: linear, clamped, no mipmap levels, unless set otherwise later.
struct Texture {
  TextureName name;
  int width = 0, height = 0;
  static Texture create(GLint internal, int width, int height, GLenum format, GLenum type,
                        const void* pixels);
  void bind(int unit) const { calls::bind_texture(unit, name.get()); }
};

/// A render target: 8-bit colour, depth and stencil on request, `samples` > 0 for multisampling.
class Target {
 public:
  Target() = default;
  Target(int width, int height, bool depth, int samples);
  int width() const { return width_; }
  int height() const { return height_; }
  /// Directs drawing here, over its whole size.
  void bind() const;
  /// Copies the picture into `to` (same size), resolving samples.
  void resolve_to(const Target& to) const;
  int samples() const { return samples_; }
  /// Only for multisampled targets: binds it to texture unit `unit`, to fetch single samples.
  void bind_samples(int unit) const { calls::bind_samples(unit, sampled_.get()); }
  /// Only for targets without multisampling.
  const Texture& color() const { return color_; }
  Texture take_color() { return std::move(color_); }
  /// Only for targets with depth and without multisampling.
  const Texture& depth() const { return depth_; }
  GLuint framebuffer() const { return framebuffer_.get(); }

 private:
  int width_ = 0, height_ = 0, samples_ = 0;
  FramebufferName framebuffer_;
  Texture color_;
  TextureName sampled_;
  Texture depth_;
  RenderbufferName sampled_depth_;
};

/// Indexed triangles, one triangle strip, or points, with interleaved float attributes of the given
/// sizes, at locations 0, 1, ...
class Mesh {
 public:
  enum class Of : std::uint8_t { triangles, strip, points };
  Mesh() = default;
  Mesh(const float* vertices, std::size_t floats, const std::uint32_t* indices,
       std::size_t index_count, std::initializer_list<int> attributes, Of of = Of::triangles);
  void draw() const { draw_some(0, count_); }
  void draw_some(int first, int count) const;
  /// Draws all of it `times` times in one call, gl_InstanceID from 0.
  void draw_times(int times) const;
  int count() const { return count_; }

 private:
  ArrayName array_;
  BufferName vertices_, indices_;
  int count_ = 0;
  Of of_ = Of::triangles;
};

/// `columns` x `rows` cells over the unit square, row by row: the place attribute of most programs.
/// One strip, which needs a third of the vertices.
Mesh unit_grid(int columns, int rows);
/// Number of indices in its first `rows` rows.
int indices_of_rows(int columns, int rows);
/// A disc with `corners` (3 times a power of two) corners, numbered round it from 0. Made of few
/// large triangles, without slivers in the middle.
std::vector<std::uint32_t> disc_indices(std::uint32_t corners);

}  // namespace onggi::render
