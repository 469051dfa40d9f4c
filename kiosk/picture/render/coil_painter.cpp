#include "kiosk/picture/render/coil_painter.h"

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

void CoilPainter::draw(const view::PotView& pot, float rim, Opening opening, const glm::mat4& clip,
                       const std::function<void(const Program&)>& light) {
  make_coil(mesh_, pot.coil, pot.clay_angle, opening);
  if (mesh_.indices.empty()) return;
  program_.use();
  light(program_);
  program_.set("clip_from_studio", clip);
  program_.set("rim", rim);
  program_.set("coil", static_cast<float>(pot.coil.diameter));
  program_.set("clay_angle", static_cast<float>(pot.clay_angle));
  program_.set("wetness", pot.wetness_by_row.empty() ? static_cast<float>(pot.wetness)
                                                     : pot.wetness_by_row.back());
  // It grows with every frame, so its buffers are made anew: 50 kB for most of a ring.
  const Mesh mesh(&mesh_.corners.front().at.x, 6 * mesh_.corners.size(), mesh_.indices.data(),
                  mesh_.indices.size(), {3, 3});
  mesh.draw();
}

}  // namespace onggi::render
