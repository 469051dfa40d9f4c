#include "kiosk/picture/render/edges.h"

#include <cstddef>

#include "kiosk/picture/render/changed_part.h"
#include "kiosk/picture/render/shaders.h"

namespace onggi::render {
namespace {

// Pixels of the picture to each side of an edge: farther, no pixel is read through which the edge
// runs, whatever its direction.
constexpr float kBeside = 1.42f;
constexpr int kEdgeSpace = 0, kEdgeGround = 1, kEdgeAway = 2, kEdgeStrips = 3;  // texture units

void attribute(GLuint at, int size, GLenum type, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(at);
  glVertexAttribPointer(at, size, type, type == GL_FLOAT ? GL_FALSE : GL_TRUE,
                        static_cast<GLsizei>(stride), reinterpret_cast<const void*>(offset));
}

}  // namespace

void Edges::Buffers::create() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  array = ArrayName(name);
  calls::bind_array(name);
  glGenBuffers(1, &name);
  corners = BufferName(name);
  glBindBuffer(GL_ARRAY_BUFFER, name);
  glGenBuffers(1, &name);
  indices = BufferName(name);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, name);
}

Result<std::unique_ptr<Edges>> Edges::create() {
  std::unique_ptr<Edges> edges(new Edges);
  auto program = Program::create("edge", {k_common_glsl, k_edge_glsl});
  if (!program) return tl::unexpected(program.error());
  edges->program_ = std::move(*program);
  edges->strips_target_ = Target(Strips::kWide, Strips::kTall, false, 0);
  edges->ribbons_.create();
  attribute(0, 4, GL_FLOAT, sizeof(EdgeCorner), offsetof(EdgeCorner, at));
  attribute(1, 3, GL_FLOAT, sizeof(EdgeCorner), offsetof(EdgeCorner, strip));
  attribute(2, 3, GL_BYTE, sizeof(EdgeCorner), offsetof(EdgeCorner, normal));
  edges->strips_.create();
  attribute(0, 3, GL_FLOAT, sizeof(StripCorner), offsetof(StripCorner, place));
  attribute(1, 2, GL_FLOAT, sizeof(StripCorner), offsetof(StripCorner, strip));
  return edges;
}

glm::vec4 Edges::unrolled_lip() {
  const glm::vec2 from(Strips::x(0.0f), Strips::y(Strips::kLip)),
      to(Strips::x(1.0f), Strips::y(Strips::kLip + Strips::kLipRows - 1));
  // A little more, so that the outermost middles are inside.
  constexpr float kMore = 1.002f;
  return glm::vec4(2.0f * kMore * (to - from),
                   kMore * (2.0f * from - 1.0f) - (kMore - 1.0f) * (to + from - 1.0f));
}

void Edges::prepare(const ClaySurface& clay, const view::PotView& pot, const glm::mat4& clip,
                    double scale) {
  wide_ = kBeside * static_cast<float>(1.0 / scale);
  float view[16], projection[16];
  pot.camera.matrices(view, projection);
  // Of these two the depth is made (Camera::matrices).
  distance_of_ = {projection[10], projection[14]};
  now_ = outline_of(clay, pot, clip, wide_);
  calls::bind_array(ribbons_.array.get());
  glBindBuffer(GL_ARRAY_BUFFER, ribbons_.corners.get());
  upload_difference(GL_ARRAY_BUFFER, uploaded_.corners, now_.corners, ribbons_.room);
  upload_difference(GL_ELEMENT_ARRAY_BUFFER, uploaded_.indices, now_.indices, ribbons_.index_room);
  wall_ = now_.wall.size();
  wheel_ = now_.wheel.size();
  strip_indices_ = now_.wall;
  strip_indices_.insert(strip_indices_.end(), now_.wheel.begin(), now_.wheel.end());
  calls::bind_array(strips_.array.get());
  glBindBuffer(GL_ARRAY_BUFFER, strips_.corners.get());
  upload_difference(GL_ARRAY_BUFFER, uploaded_.strips, now_.strips, strips_.room);
  upload_difference(GL_ELEMENT_ARRAY_BUFFER, uploaded_strip_indices_, strip_indices_,
                    strips_.index_room);
  strips_target_.bind();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
}

void Edges::draw_strips(std::size_t first, std::size_t count) const {
  if (count == 0) return;
  calls::bind_array(strips_.array.get());
  calls::draw_elements(GL_TRIANGLE_STRIP, static_cast<GLsizei>(count), GL_UNSIGNED_INT, first);
}

void Edges::draw(const Target& space, const Texture& ground, float opacity, int width, int height) {
  if (now_.indices.empty()) return;
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  program_.use();
  program_.set("size", glm::vec2(width, height));
  program_.set("wide", wide_);
  program_.set("distance_of", distance_of_);
  program_.set("opacity", opacity);
  space.color().bind(kEdgeSpace);
  program_.set("space", kEdgeSpace);
  ground.bind(kEdgeGround);
  program_.set("ground", kEdgeGround);
  space.depth().bind(kEdgeAway);
  program_.set("away", kEdgeAway);
  strips_target_.color().bind(kEdgeStrips);
  program_.set("strips", kEdgeStrips);
  calls::bind_array(ribbons_.array.get());
  calls::draw_elements(GL_TRIANGLE_STRIP, static_cast<GLsizei>(now_.indices.size()),
                       GL_UNSIGNED_INT, 0);
}

}  // namespace onggi::render
