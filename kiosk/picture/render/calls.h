#pragma once

#include <epoxy/gl.h>

#include <cstddef>

#include "kiosk/picture/render/frame_work.h"

/// All GL calls that draw, upload, copy or switch, with counters: no other file makes such calls
/// (tests/kiosk/picture/render/calls_test.cpp). The counters belong to the thread, like the
/// context.
namespace onggi::render::calls {

const FrameWork& so_far();

void use_program(GLuint name);
void bind_array(GLuint name);
void bind_framebuffer(GLenum target, GLuint name);
/// Binds to texture unit `unit`.
void bind_texture(int unit, GLuint name);
/// Binds to the current unit, for an upload or to set filters.
void bind_texture(GLuint name);
/// A multisampled texture.
void bind_samples(int unit, GLuint name);

/// `first`: in the indices, which are of `type`.
void draw_elements(GLenum mode, GLsizei count, GLenum type, std::size_t first);
void draw_elements_times(GLenum mode, GLsizei count, GLenum type, GLsizei times);

/// `data` null: allocates without uploading.
void buffer_data(GLenum target, std::size_t bytes, const void* data, GLenum usage);
void buffer_part(GLenum target, std::size_t offset, std::size_t bytes, const void* data);
/// For the current texture, of its mipmap level `level`. `pixels` null: allocates without
/// uploading. Rows are `row_length` pixels apart, 0: without gaps.
void texture_image(GLint level, GLint internal, int width, int height, GLenum format, GLenum type,
                   const void* pixels);
void texture_part(int x, int y, int width, int height, GLenum format, GLenum type,
                  const void* pixels, int row_length = 0, int level = 0);

/// Allocates a multisampled texture, for the current one.
void texture_samples(int samples, GLint internal, int width, int height);

/// Copies the colours of a rectangle from the read framebuffer to the draw framebuffer. From the
/// lower left.
void copy(int x, int y, int width, int height);
/// The same for depth and stencil; both are of one kind and have one sample a pixel.
void copy_depth(int x, int y, int width, int height);

/// Counts shader runs during its life, if `on` and if the driver can. Waits for them at its end.
class Shading {
 public:
  explicit Shading(bool on);
  ~Shading();
  Shading(const Shading&) = delete;
  Shading& operator=(const Shading&) = delete;
  /// True if the driver can.
  static bool counted();

 private:
  GLuint queries_[2] = {};
};

}  // namespace onggi::render::calls
