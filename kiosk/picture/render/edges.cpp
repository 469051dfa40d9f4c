#include "kiosk/picture/render/edges.h"

#include <cstddef>

#include "kiosk/picture/render/changed_part.h"
#include "kiosk/picture/render/coil_outline.h"
#include "kiosk/picture/render/shaders.h"

namespace onggi::render {
namespace {

constexpr int kEdgeSpace = 0, kEdgeGround = 1, kEdgeAway = 2, kEdgeStrip = 3,
              kEdgeBare = 4;  // texture units

void attribute(GLuint at, std::size_t offset) {
  glEnableVertexAttribArray(at);
  glVertexAttribPointer(at, 3, GL_FLOAT, GL_FALSE, sizeof(EdgeCorner),
                        reinterpret_cast<const void*>(offset));
}

}  // namespace

void BareDepths::keep(const Target& space, glm::ivec4 around) {
  part = around;
  if (part.x >= part.z || part.y >= part.w) return;
  if (target.width() != space.width() || target.height() != space.height())
    target = Target(space.width(), space.height(), true, 0);
  calls::bind_framebuffer(GL_READ_FRAMEBUFFER, space.framebuffer());
  calls::bind_framebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer());
  calls::copy_depth(part.x, part.y, part.z - part.x, part.w - part.y);
  space.bind();
}

Result<std::unique_ptr<Edges>> Edges::create() {
  std::unique_ptr<Edges> edges(new Edges);
  for (const std::size_t mode : {0u, 1u}) {
    const std::string which = "#define MODE " + std::to_string(mode) + "\n";
    auto program = Program::create("edge", {which.c_str(), k_common_glsl, k_edge_glsl});
    if (!program) return tl::unexpected(program.error());
    edges->programs_[mode] = std::move(*program);
  }
  edges->strip_ = Target(LipStrip::kWide, LipStrip::kTall, false, 0);
  edges->lip_ = unit_grid(48, 3);
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  edges->array_ = ArrayName(name);
  calls::bind_array(name);
  glGenBuffers(1, &name);
  edges->corners_ = BufferName(name);
  glBindBuffer(GL_ARRAY_BUFFER, name);
  glGenBuffers(1, &name);
  edges->indices_ = BufferName(name);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, name);
  attribute(0, offsetof(EdgeCorner, at));
  attribute(1, offsetof(EdgeCorner, depths));
  attribute(2, offsetof(EdgeCorner, strip));
  return edges;
}

void Edges::prepare(const ClaySurface& clay, const CoatTexture& coat, const WallMesh& wall,
                    const MeshEdges& vessel, Opening opening, const view::PotView& pot,
                    const glm::mat4& clip, double scale) {
  const auto texel = static_cast<float>(1.0 / scale);
  now_ = outline_of(clay, coat, wall, pot, clip, texel);
  if (pot.beside) add_mesh_outline(now_, vessel, *pot.beside, texel);
  add_coil_outline(now_, pot.coil, pot.clay_angle, opening, pot.camera, texel);
  put_farthest_first(now_.corners, now_.outlines);
  now_indices_ = now_.outlines;
  now_indices_.insert(now_indices_.end(), now_.creases.begin(), now_.creases.end());
  calls::bind_array(array_.get());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.get());
  upload_difference(GL_ARRAY_BUFFER, uploaded_corners_, now_.corners, corner_room_);
  upload_difference(GL_ELEMENT_ARRAY_BUFFER, uploaded_indices_, now_indices_, index_room_);
  strip_.bind();
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
}

void Edges::draw(const Target& space, const BareDepths& bare, const Texture& ground, float opacity,
                 int width, int height) {
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  const std::size_t outlines = now_.outlines.size();
  for (const std::size_t mode : {1u, 0u}) {
    const std::size_t first = mode == 0 ? 0 : outlines,
                      count = mode == 0 ? outlines : now_.creases.size();
    if (count == 0) continue;
    const Program& program = programs_[mode];
    program.use();
    program.set("size", glm::vec2(width, height));
    program.set("opacity", opacity);
    space.color().bind(kEdgeSpace);
    program.set("space", kEdgeSpace);
    ground.bind(kEdgeGround);
    program.set("ground", kEdgeGround);
    strip_.color().bind(kEdgeStrip);
    program.set("strips", kEdgeStrip);
    space.depth().bind(kEdgeAway);
    program.set("away", kEdgeAway);
    if (mode == 0) {
      const Target& without = bare.target.width() > 0 ? bare.target : space;
      without.depth().bind(kEdgeBare);
      program.set("bare", kEdgeBare);
      program.set("fingers", glm::vec4(bare.part));
      const glm::vec2 slope =
          glm::vec2(now_.head) *
          glm::vec2(static_cast<float>(width) / static_cast<float>(space.width()),
                    static_cast<float>(height) / static_cast<float>(space.height()));
      program.set("disc", now_.disc);
      program.set("head", glm::vec4(slope, now_.head.z + 0.5f * (slope.x + slope.y), now_.head.w));
    }
    calls::bind_array(array_.get());
    calls::draw_elements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT, first);
  }
}

}  // namespace onggi::render
