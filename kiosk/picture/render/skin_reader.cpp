#include "kiosk/picture/render/skin_reader.h"

#include <algorithm>
#include <array>

#include "kiosk/picture/render/gl.h"

namespace onggi::render {
namespace {

constexpr int kReadWidth = 1024;   // texels
constexpr std::size_t kParts = 4;  // of clay.glsl: outer wall, lip, inner wall, floor

/// PART in clay.glsl. The foot is the lowest outer wall.
std::size_t part_of(ClayFace face) {
  switch (face) {
    case ClayFace::rim:
      return 1;
    case ClayFace::inner:
      return 2;
    case ClayFace::floor:
      return 3;
    case ClayFace::foot:
    case ClayFace::outer:
      break;
  }
  return 0;
}

/// A float target, because light does not fit into 8 bits.
struct ReadTarget {
  FramebufferName framebuffer;
  Texture texels;
  ReadTarget(int width, int height)
      : texels(Texture::create(GL_RGBA32F, width, height, GL_RGBA, GL_FLOAT, nullptr)) {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    framebuffer = FramebufferName(name);
    calls::bind_framebuffer(GL_FRAMEBUFFER, name);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texels.name.get(),
                           0);
    glViewport(0, 0, width, height);
  }
};

}  // namespace

std::vector<view::SkinPoint> read_surface(const ClayMesh& pot,
                                          const std::function<void(std::size_t part)>& use) {
  const std::size_t count = pot.faces.size();
  std::vector<view::SkinPoint> out(count);
  if (count == 0) return out;
  const int high = (static_cast<int>(count) + kReadWidth - 1) / kReadWidth;
  const ReadTarget target(kReadWidth, high);
  // Each position is a point on its own texel, in the mesh's order.
  std::vector<float> places;
  places.reserve(5 * count);
  std::array<std::vector<std::uint32_t>, kParts> of_part;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [x, y, z] = pot.mesh.positions[i];
    const auto column = static_cast<float>(i % kReadWidth),
               row = static_cast<float>(i / kReadWidth);
    places.insert(places.end(), {x, y, z, (2.0f * column + 1.0f) / kReadWidth - 1.0f,
                                 (2.0f * row + 1.0f) / static_cast<float>(high) - 1.0f});
    of_part[part_of(pot.faces[i])].push_back(static_cast<std::uint32_t>(i));
  }
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  for (std::size_t part = 0; part < kParts; ++part) {
    const Mesh points(places.data(), places.size(), of_part[part].data(), of_part[part].size(),
                      {3, 2}, Mesh::Of::points);
    use(part);
    points.draw();
  }
  // Rows of four floats need no alignment.
  std::vector<std::array<float, 4>> texels(static_cast<std::size_t>(kReadWidth) *
                                           static_cast<std::size_t>(high));
  glReadPixels(0, 0, kReadWidth, high, GL_RGBA, GL_FLOAT, texels.data());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [r, g, b, roughness] = texels[i];
    const auto share = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
    out[i] = {{share(r), share(g), share(b)}, share(roughness)};
  }
  return out;
}

}  // namespace onggi::render
