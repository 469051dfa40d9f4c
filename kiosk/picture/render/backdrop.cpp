#include "kiosk/picture/render/backdrop.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "kiosk/picture/render/shaders.h"

namespace onggi::render {
namespace {

constexpr int kShadowSize = 224;
constexpr float kSkyGone = 0.24f;  // m from the foot; same as in ground.glsl
constexpr float kEven = 0.02f;     // m: extents are rounded to it, so that they seldom change

// Texture units.
constexpr int kGroundLevels = 2, kGroundSky = 3, kGroundShadow = 5, kSpace = 0, kGround = 1;

}  // namespace

Result<std::unique_ptr<Backdrop>> Backdrop::create() {
  std::unique_ptr<Backdrop> out(new Backdrop);
  Result<void> fine;
  const auto make = [&fine](Program& into, const char* name, const char* text, int mode) {
    if (!fine) return;
    const std::string which = "#define MODE " + std::to_string(mode) + "\n";
    auto made = Program::create(name, {which.c_str(), k_common_glsl, text});
    if (made)
      into = std::move(*made);
    else
      fine = tl::unexpected(made.error());
  };
  make(out->shadow_program_, "shadow", k_shadow_glsl, 0);
  make(out->plaster_program_, "plaster", k_plaster_glsl, 0);
  make(out->layer_program_, "ground", k_ground_glsl, 0);
  make(out->ground_program_, "ground", k_ground_glsl, 1);
  make(out->lay_programs_[0], "space", k_space_glsl, 0);
  make(out->lay_programs_[1], "space", k_space_glsl, 1);
  if (!fine) return tl::unexpected(fine.error());
  out->quad_ = unit_grid(1, 1);
  for (Cast& cast : out->casts_) cast.shadow = Target(kShadowSize, kShadowSize, false, 0);
  return out;
}

void Backdrop::cast(Of of, const Levels& levels, const Texture& light, const Studio& studio,
                    float wheel_radius, float size, double apart_by) {
  Cast& own = casts_[place(of)];
  if (own.of && own.wheel == wheel_radius && own.size == size && own.window == studio.window() &&
      apart(*own.of, levels) <= apart_by)
    return;
  own.of = levels;
  own.wheel = wheel_radius;
  own.size = size;
  own.window = studio.window();
  ++own.serial;
  GLint viewport[4], back_to = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &back_to);
  glGetIntegerv(GL_VIEWPORT, viewport);
  // The canvas has set a scissor for the picture. The shadow has its own pixels.
  const bool cut_out = glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
  glDisable(GL_SCISSOR_TEST);
  own.shadow.bind();
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  shadow_program_.use();
  studio.light(shadow_program_, kGroundSky);
  light.bind(kGroundLevels);
  shadow_program_.set("levels", kGroundLevels);
  // A smaller pot in the studio looks like the pot in a larger studio, because distant light has no
  // scale.
  shadow_program_.set("reach", kReach / size);
  shadow_program_.set("height", static_cast<float>(levels.height));
  shadow_program_.set("table_y", kTable / size);
  shadow_program_.set("wheel_radius", wheel_radius / size);
  quad_.draw();
  if (cut_out) glEnable(GL_SCISSOR_TEST);
  calls::bind_framebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(back_to));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

Backdrop::Extent Backdrop::darkened(double height, double radius, bool wheel, float foot,
                                    glm::vec3 light) {
  const float along = (static_cast<float>(height) - (wheel ? kTable : 0.0f)) / light.y;
  // The rim's shadow and its soft edge (shadow.glsl), and the dark area around the foot.
  const float around = static_cast<float>(radius) + 0.5f * (0.0025f + 0.24f * along);
  const float x = -light.x * along, z = -light.z * along, near = foot + kSkyGone;
  const auto even = [](float v, float up) {
    return std::clamp(kEven * (up > 0 ? std::ceil(v / kEven) : std::floor(v / kEven)), -kReach,
                      kReach);
  };
  return {even(std::min(-near, x - around), -1), even(std::min(-near, z - around), -1),
          even(std::max(near, x + around), 1), even(std::max(near, z + around), 1)};
}

void Backdrop::draw_plaster(int width, int height, double window) const {
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  plaster_program_.use();
  plaster_program_.set("size", glm::vec2(width, height));
  plaster_program_.set("side", static_cast<float>(std::sin(window) / std::sin(view::kWindowLeft)));
  quad_.draw();
}

void Backdrop::ground(const Program& program, Of of, const glm::mat4& clip, const Extent& extent,
                      bool wheel, float foot, float strength) const {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  shadow(of).bind(kGroundShadow);
  program.set("shadow", kGroundShadow);
  program.set("clip_from_studio", clip);
  program.set("low", glm::vec2(extent.left, extent.back));
  program.set("high", glm::vec2(extent.right, extent.front));
  program.set("reach", kReach);
  program.set("plane_y", wheel ? kTable : 0.0f);
  program.set("of_table", wheel ? 1.0f : 0.0f);
  program.set("foot", foot);
  program.set("strength", strength);
}

void Backdrop::draw_ground(const glm::mat4& clip, const Texture& plaster, const Extent& extent,
                           bool wheel, float foot, float opacity) const {
  glDisable(GL_BLEND);
  ground_program_.use();
  ground(ground_program_, Of::clay, clip, extent, wheel, foot, wheel ? 0.9f : 1.0f);
  plaster.bind(kGround);
  ground_program_.set("plaster", kGround);
  ground_program_.set("opacity", opacity);
  quad_.draw();
}

void Backdrop::draw_ground_layer(const glm::mat4& clip, float foot, float strength, glm::vec2 size,
                                 glm::vec2 edge) const {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  layer_program_.use();
  ground(layer_program_, Of::mesh, clip, {-kReach, -kReach, kReach, kReach}, false, foot, strength);
  layer_program_.set("size", size);
  layer_program_.set("edge", edge);
  quad_.draw();
}

void Backdrop::lay(const Target& space, const Texture& ground, const view::Rect& box, float opacity,
                   int width, int height) const {
  if (box.w <= 0 || box.h <= 0) return;
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  const Program& program = lay_programs_[space.samples() > 0 ? 1 : 0];
  program.use();
  if (space.samples() > 0) {
    space.bind_samples(kSpace);
    program.set("samples", space.samples());
  } else {
    space.color().bind(kSpace);
  }
  program.set("space", kSpace);
  ground.bind(kGround);
  program.set("ground", kGround);
  program.set("opacity", opacity);
  program.set("size", glm::vec2(width, height));
  program.set("box", glm::vec4(box.x, static_cast<float>(height) - box.y - box.h, box.w, box.h));
  quad_.draw();
}

}  // namespace onggi::render
