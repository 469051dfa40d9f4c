#include "kiosk/picture/render/coil_painter.h"

#include <vector>

#include "kiosk/picture/render/shaders.h"

namespace onggi::render {

Result<std::unique_ptr<CoilPainter>> CoilPainter::create() {
  std::unique_ptr<CoilPainter> painter(new CoilPainter);
  auto program =
      Program::create("coil", {k_common_glsl, k_light_glsl, k_bare_clay_glsl, k_coil_glsl});
  if (!program) return tl::unexpected(program.error());
  painter->program_ = std::move(*program);
  return painter;
}

void CoilPainter::prepare(const view::PotView& pot, Opening opening) {
  mesh_ = coil_mesh(pot.coil, pot.clay_angle, opening);
}

void CoilPainter::draw(const view::PotView& pot, float rim, const glm::mat4& clip,
                       const std::function<void(const Program&)>& light) const {
  if (mesh_.triangles.empty()) return;
  program_.use();
  light(program_);
  program_.set("clip_from_studio", clip);
  program_.set("rim", rim);
  program_.set("coil", static_cast<float>(pot.coil.diameter));
  program_.set("clay_angle", static_cast<float>(pot.clay_angle));
  program_.set("wetness", pot.wetness_by_row.empty() ? static_cast<float>(pot.wetness)
                                                     : pot.wetness_by_row.back());
  // It turns and grows with every frame, so its buffers are made anew: 50 kB for most of a ring.
  std::vector<float> corners;
  corners.reserve(6 * mesh_.positions.size());
  for (std::size_t n = 0; n < mesh_.positions.size(); ++n) {
    corners.insert(corners.end(), mesh_.positions[n].begin(), mesh_.positions[n].end());
    corners.insert(corners.end(), mesh_.normals[n].begin(), mesh_.normals[n].end());
  }
  const Mesh mesh(corners.data(), corners.size(), mesh_.triangles.front().data(),
                  3 * mesh_.triangles.size(), {3, 3});
  mesh.draw();
}

}  // namespace onggi::render
