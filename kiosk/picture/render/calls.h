#pragma once

#include <epoxy/gl.h>

#include <cstddef>

#include "kiosk/picture/render/frame_work.h"

/// Every GL call that draws, uploads, copies or switches, and the count of them: no other file
/// makes one (tests/kiosk/picture/render/calls_test.cpp). As the context is the thread's, so is the
/// count.
namespace onggi::render::calls {

const FrameWork& so_far();

void use_program(GLuint name);
void bind_array(GLuint name);
void bind_framebuffer(GLenum target, GLuint name);
/// To texture unit `unit`.
void bind_texture(int unit, GLuint name);
/// To the unit at hand: to upload, or to set how it is read.
void bind_texture(GLuint name);
/// One of many samples a texel.
void bind_samples(int unit, GLuint name);

/// `first`: of the indices, which are of `type`.
void draw_elements(GLenum mode, GLsizei count, GLenum type, std::size_t first);
/// All of them so many times.
void draw_elements_times(GLenum mode, GLsizei count, GLenum type, GLsizei times);

/// `data` null: room, and nothing is uploaded.
void buffer_data(GLenum target, std::size_t bytes, const void* data, GLenum usage);
void buffer_part(GLenum target, std::size_t offset, std::size_t bytes, const void* data);
/// Of the texture at hand. `pixels` null: room, and nothing is uploaded. Rows lie `row_length`
/// pixels apart, 0: without gaps.
void texture_image(GLint level, GLint internal, int width, int height, GLenum format, GLenum type,
                   const void* pixels);
void texture_part(int x, int y, int width, int height, GLenum format, GLenum type,
                  const void* pixels, int row_length = 0);

/// Room for a texture of many samples a texel, of the one at hand.
void texture_samples(int samples, GLint internal, int width, int height);

/// Colour of a rectangle of the read framebuffer to the same of the drawn one. From the lower left.
void copy(int x, int y, int width, int height);

/// Counts shader runs while it lives, where `on` and the driver can; waits for them at its end.
class Shading {
 public:
  explicit Shading(bool on);
  ~Shading();
  Shading(const Shading&) = delete;
  Shading& operator=(const Shading&) = delete;
  /// The driver can.
  static bool counted();

 private:
  GLuint queries_[2] = {};
};

}  // namespace onggi::render::calls
