#pragma once

#include <vector>

#include "kiosk/picture/render/gl.h"

namespace onggi::render::testing {

/// What a texture of one channel holds, as shares of the most that it can. Row by row. By a
/// framebuffer, as OpenGL ES reads no texture; `whole_numbers`: there it has whole numbers of 16
/// bits, or of 8.
inline std::vector<float> shares_of(const Texture& texture, bool whole_numbers = false) {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  const FramebufferName framebuffer(name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name.get(),
                         0);
  const auto count =
      static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
  std::vector<float> out(count);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  if (!embedded()) {
    glReadPixels(0, 0, texture.width, texture.height, GL_RED, GL_FLOAT, out.data());
  } else if (whole_numbers) {
    std::vector<GLuint> rgba(4 * count);
    glReadPixels(0, 0, texture.width, texture.height, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                 rgba.data());
    for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<float>(rgba[4 * i]) / 65535.0f;
  } else {
    std::vector<GLubyte> rgba(4 * count);
    glReadPixels(0, 0, texture.width, texture.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<float>(rgba[4 * i]) / 255.0f;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return out;
}

}  // namespace onggi::render::testing
