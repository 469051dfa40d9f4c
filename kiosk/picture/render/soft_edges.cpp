#include "kiosk/picture/render/soft_edges.h"

#include "kiosk/picture/render/shaders.h"

namespace onggi::render {
namespace {

constexpr GLuint kDrawn = 2;  // bit of the stencil; the first one belongs to the wheel head

}  // namespace

Result<SoftEdges> SoftEdges::create() {
  SoftEdges out;
  out.by_driver_ = !embedded() || epoxy_has_gl_extension("GL_EXT_multisample_compatibility");
  if (out.by_driver_) return out;
  auto opaque = Program::create("opaque", {k_opaque_glsl});
  if (!opaque) return tl::unexpected(opaque.error());
  out.opaque_ = std::move(*opaque);
  out.all_ = unit_grid(1, 1);
  return out;
}

void SoftEdges::begin() const {
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  if (by_driver_) {
    glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    return;
  }
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, kDrawn, kDrawn);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void SoftEdges::end() const {
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  if (by_driver_) {
    glDisable(GL_SAMPLE_ALPHA_TO_ONE);
    return;
  }
  const bool depth = glIsEnabled(GL_DEPTH_TEST) == GL_TRUE,
             cull = glIsEnabled(GL_CULL_FACE) == GL_TRUE, blend = glIsEnabled(GL_BLEND) == GL_TRUE;
  for (const GLenum test : {GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND}) glDisable(test);
  glStencilFunc(GL_EQUAL, kDrawn, kDrawn);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  opaque_.use();
  all_.draw();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_STENCIL_TEST);
  if (depth) glEnable(GL_DEPTH_TEST);
  if (cull) glEnable(GL_CULL_FACE);
  if (blend) glEnable(GL_BLEND);
}

}  // namespace onggi::render
