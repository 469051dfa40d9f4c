#pragma once

#include <epoxy/gl.h>

#include <cstddef>

#include "kiosk/render/frame_work.h"

/// Every GL call that draws, uploads, copies or switches, and the count of them: no other file
/// makes one (tests/kiosk/render/calls_test.cpp). As the context is the thread's, so is the count.
namespace onggi::render::calls {

const FrameWork& so_far();

void use_program(GLuint name);
void bind_array(GLuint name);
void bind_framebuffer(GLenum target, GLuint name);
/// To texture unit `unit`.
void bind_texture(int unit, GLuint name);
/// To the unit at hand: to upload, or to set how it is read.
void bind_texture(GLuint name);

/// `first`: of the indices, which are of `type`.
void draw_elements(GLenum mode, GLsizei count, GLenum type, std::size_t first);
void draw_arrays(GLenum mode, GLint first, GLsizei count);

/// `data` null: room, and nothing is uploaded.
void buffer_data(GLenum target, std::size_t bytes, const void* data, GLenum usage);
void buffer_part(GLenum target, std::size_t offset, std::size_t bytes, const void* data);
/// Of the texture at hand, from rows without gaps. `pixels` null: room, and nothing is uploaded.
void texture_image(GLint level, GLint internal, int width, int height, GLenum format, GLenum type,
                   const void* pixels);
void texture_part(int x, int y, int width, int height, GLenum format, GLenum type,
                  const void* pixels);

/// Colour of the read framebuffer's lower left width x height to the drawn one's.
void copy(int width, int height);

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
