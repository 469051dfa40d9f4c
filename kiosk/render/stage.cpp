#include "kiosk/render/stage.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <string>

#include "kiosk/render/shaders.h"

namespace onggi::render {
namespace {

constexpr float kTable = -0.024f;      // the table's height under the wheel head's top
constexpr float kShadowReach = 0.62f;  // metres from the axis that the shadow texture covers
constexpr int kShadowSize = 224;

// Meshes of the walls, and the pot's height in pixels up to which each is fine enough. Light and
// grooves come from the radius textures at every pixel; a mesh only owes the outline, and a chord
// of 6 pixels is within 0.2 of an arc of 25. Small triangles cost dearly: a software rasterizer
// shades 4 x 4 pixels for each that it touches, whatever part of them is the triangle's.
struct Wall {
  int columns, rows;
  float most_pixels;
};
constexpr std::array<Wall, 4> kWalls{
    {{44, 48, 280.0f}, {60, 96, 580.0f}, {96, 192, 1200.0f}, {192, 400, 1e9f}}};

// Texture units.
constexpr int kOuter = 0, kInner = 1, kLevelsUnit = 2, kSky = 3, kGrain = 4, kShadow = 5,
              kRowAt = 6, kWetRows = 7, kTornAt = 8, kOwnPicture = 9;

// Parts of clay.glsl that tear: outer wall, lip, inner wall, section of the wall.
constexpr bool kTears[] = {true, true, true, false, false, true};

glm::mat4 clip_of(const view::Camera& camera) {
  glm::mat4 view, projection;
  camera.matrices(&view[0][0], &projection[0][0]);
  return projection * view;
}

// Metres that one pixel covers at the axis.
float pixel_size(const view::Camera& camera, double scale) {
  return static_cast<float>(2.0 * camera.distance * std::tan(0.5 * camera.fov) /
                            (camera.height * scale));
}

// The angle about the axis that faces the camera.
float front_of(const view::Camera& camera) {
  return 0.5f * glm::pi<float>() - static_cast<float>(camera.azimuth);
}

}  // namespace

Result<std::unique_ptr<Stage>> Stage::create() {
  std::unique_ptr<Stage> stage(new Stage);
  Result<void> fine;
  const auto make = [&fine](Program& into, const char* name, const char* text, bool lit, int part,
                            std::size_t skin, bool torn = false) {
    if (!fine) return;
    const std::string which = "#define PART " + std::to_string(part) + "\n#define SKIN " +
                              std::to_string(skin) + (torn ? "\n#define TORN\n" : "\n");
    auto made = Program::create(name, {which.c_str(), k_common_glsl, lit ? k_light_glsl : "", text,
                                       torn ? k_torn_glsl : ""});
    if (made) {
      into = std::move(*made);
    } else {
      fine = tl::unexpected(made.error());
    }
  };
  for (int part = 0; part < 6; ++part) {
    const auto p = static_cast<std::size_t>(part);
    for (std::size_t skin = 0; skin < stage->clay_programs_.size(); ++skin) {
      make(stage->clay_programs_[skin][p], "clay", k_clay_glsl, true, part, skin);
      if (kTears[part])
        make(stage->torn_programs_[skin][p], "torn clay", k_clay_glsl, true, part, skin, true);
    }
  }
  for (const int part : {0, 1}) {
    const auto p = static_cast<std::size_t>(part);
    make(stage->wheel_programs_[p], "wheel", k_wheel_glsl, true, part, 0);
  }
  make(stage->solid_program_, "solid", k_solid_glsl, true, 0, 0);
  make(stage->shadow_program_, "shadow", k_shadow_glsl, false, 0, 0);
  make(stage->ground_program_, "ground", k_ground_glsl, false, 0, 0);
  make(stage->plaster_program_, "plaster", k_plaster_glsl, false, 0, 0);
  if (!fine) return tl::unexpected(fine.error());
  auto tools = ToolPainter::create();
  if (!tools) return tl::unexpected(tools.error());
  stage->tools_ = std::move(*tools);
  stage->quad_ = unit_grid(1, 1);
  for (std::size_t i = 0; i < kWalls.size(); ++i) {
    stage->walls_[i] = unit_grid(kWalls[i].columns, kWalls[i].rows);
  }
  stage->lip_ = unit_grid(160, 12);
  stage->floor_ = unit_grid(96, 8);
  stage->section_ = unit_grid(16, 320);
  stage->disc_ = unit_disc(96);
  stage->edge_ = unit_grid(96, 1);
  stage->shadow_ = Target(kShadowSize, kShadowSize, false, 0);
  return stage;
}

void Stage::draw_plaster(int width, int height) {
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  plaster_program_.use();
  plaster_program_.set("size", glm::vec2(width, height));
  quad_.draw();
}

void Stage::cast_shadow(double height, float wheel_radius, const Texture& levels, GLint back_to,
                        float size) {
  GLint viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  // The canvas has cut out its part of the picture; the shadow has pixels of its own.
  const bool cut_out = glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
  glDisable(GL_SCISSOR_TEST);
  shadow_.bind();
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  shadow_program_.use();
  studio_.light(shadow_program_, kSky);
  levels.bind(kLevelsUnit);
  shadow_program_.set("levels", kLevelsUnit);
  // A smaller pot in the studio is the pot in a larger studio: light from afar knows no size.
  shadow_program_.set("reach", kShadowReach / size);
  shadow_program_.set("height", static_cast<float>(height));
  shadow_program_.set("table_y", kTable / size);
  shadow_program_.set("wheel_radius", wheel_radius / size);
  quad_.draw();
  if (cut_out) glEnable(GL_SCISSOR_TEST);
  calls::bind_framebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(back_to));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

void Stage::set_light(const Program& program, const view::Camera& camera, const Texture& levels) {
  studio_.light(program, kSky);
  levels.bind(kLevelsUnit);
  program.set("levels", kLevelsUnit);
  studio_.grain().bind(kGrain);
  program.set("grain", kGrain);
  shadow_.color().bind(kShadow);
  program.set("shadow", kShadow);
  program.set("eye", vec(camera.eye()));
}

void Stage::draw_ground(const glm::mat4& clip, bool wheel, float foot, float strength,
                        glm::vec2 faded_size) {
  ground_program_.use();
  shadow_.color().bind(kShadow);
  ground_program_.set("shadow", kShadow);
  ground_program_.set("clip_from_studio", clip);
  ground_program_.set("reach", kShadowReach);
  ground_program_.set("plane_y", wheel ? kTable : 0.0f);
  ground_program_.set("of_table", wheel ? 1.0f : 0.0f);
  ground_program_.set("foot", foot);
  ground_program_.set("strength", strength);
  ground_program_.set("size", faded_size);
  ground_program_.set("edge", faded_size * glm::vec2(0.28f, 0.14f));
  quad_.draw();
}

void Stage::draw_pot(const view::PotView& pot, const Quality& quality, double scale) {
  const bool shown = !clay_.empty();
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  const float wheel_radius = pot.wheel ? static_cast<float>(pot.wheel_radius) : 0.0f;
  const auto size = static_cast<float>(std::clamp(pot.size, 0.5, 1.0));
  clay_.refresh(clay_levels_);
  if (!shadow_of_ || shadow_wheel_ != wheel_radius || shadow_size_ != size ||
      apart(*shadow_of_, clay_.levels()) > quality.shadow_apart) {
    cast_shadow(clay_.height(), wheel_radius, clay_levels_, target, size);
    shadow_of_ = clay_.levels();
    shadow_wheel_ = wheel_radius;
    shadow_size_ = size;
  }
  skin_.prepare(pot);
  glClearColor(0, 0, 0, 0);
  glClearStencil(0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  const glm::mat4 clip = clip_of(pot.camera);
  const float pixel = pixel_size(pot.camera, scale);

  // 1. What the light does not reach of the table.
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  draw_ground(clip, pot.wheel, pot.wheel ? wheel_radius : size * clay_.levels().outer[0],
              pot.wheel ? 0.9f : 1.0f);

  // 2. The clay.
  glEnable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  if (shown) {
    // The edges of a tear are in the middle of triangles, where only alpha can smooth them.
    const bool soft = clay_.tears().any() && quality.samples > 0;
    for (const GLenum smooth : {GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE})
      if (soft) glEnable(smooth);
    draw_clay(pot, clip, pixel, soft);
    for (const GLenum smooth : {GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE})
      if (soft) glDisable(smooth);
  }
  // 3. The wheel head where the clay leaves it to be seen, and the pot mirrored in it.
  if (pot.wheel) {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_ALWAYS, 1, 1);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    draw_wheel(pot, clip, pixel);
    if (quality.reflection && shown && pot.cut_away < 0.01) {
      glStencilFunc(GL_EQUAL, 1, 1);
      glDisable(GL_DEPTH_TEST);
      draw_reflection(pot, clip);
      glEnable(GL_DEPTH_TEST);
    }
    glDisable(GL_STENCIL_TEST);
  }

  // 4. The tools, which fade into the air.
  draw_hands(pot, clip);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
}

void Stage::draw_wheel(const view::PotView& pot, const glm::mat4& clip, float pixel) {
  glFrontFace(GL_CW);
  for (std::size_t part = 0; part < wheel_programs_.size(); ++part) {
    const Program& program = wheel_programs_[part];
    program.use();
    set_light(program, pot.camera, clay_levels_);
    program.set("clip_from_studio", clip);
    program.set("radius", static_cast<float>(pot.wheel_radius));
    program.set("table_y", kTable);
    program.set("reach", kShadowReach);
    program.set("wheel_angle", static_cast<float>(pot.wheel_angle));
    program.set("wetness", static_cast<float>(pot.wetness));
    program.set("pixel", pixel);
    program.set("opened", static_cast<float>(pot.cut_away));
    (part == 0 ? disc_ : edge_).draw();
  }
  glFrontFace(GL_CCW);
}

const Program& Stage::use_clay(int part, const view::PotView& pot, const glm::mat4& clip,
                               float pixel) {
  const auto open = static_cast<float>(std::clamp(pot.cut_away, 0.0, 1.0));
  const bool torn = clay_.tears().any() && kTears[part];
  const Program& program =
      (torn ? torn_programs_ : clay_programs_)[ClaySkin::of(pot)][static_cast<std::size_t>(part)];
  program.use();
  if (torn) {
    clay_.tears().texture().bind(kTornAt);
    program.set("torn_at", kTornAt);
    program.set("soft_edges", 0.0f);
  }
  set_light(program, pot.camera, clay_levels_);
  // All is computed at the thrown size; a pot that has shrunk is seen from as much farther away.
  const auto size = static_cast<float>(std::clamp(pot.size, 0.5, 1.0));
  program.set("eye", vec(pot.camera.eye()) / size);
  clay_.outer().bind(kOuter);
  clay_.inner().bind(kInner);
  program.set("outer_radius", kOuter);
  program.set("inner_radius", kInner);
  clay_.row_at().bind(kRowAt);
  program.set("row_at", kRowAt);
  program.set("first_wall_row", clay_.first_wall_row());
  program.set("top_row", clay_.top_row());
  program.set("lip_radius", static_cast<float>(kLipRadius));
  program.set("mean_lip", clay_.lip());
  program.set("clip_from_studio", glm::scale(clip, glm::vec3(size)));
  program.set("grid", glm::vec2(clay_.sectors(), clay_.texture_rows()));
  program.set("height", static_cast<float>(clay_.height()));
  program.set("floor_height", static_cast<float>(clay_.floor_top()));
  program.set("clay_angle", static_cast<float>(pot.clay_angle));
  // The door is hinged at the visitor's right: it opens from the front towards there.
  program.set("open_from", front_of(pot.camera) - 0.5f * glm::pi<float>() * open);
  program.set("open_angle", 0.5f * glm::pi<float>() * open);
  program.set("opened", open);
  program.set("mirrored", 0.0f);
  program.set("pixel", pixel / size);
  program.set("wetness", static_cast<float>(pot.wetness));
  skin_.set(program, pot, kWetRows);
  return program;
}

void Stage::draw_clay(const view::PotView& pot, const glm::mat4& clip, float pixel, bool soft) {
  const auto tall = static_cast<float>(clay_.height()) / pixel;
  std::size_t size = 0;
  while (tall > kWalls[size].most_pixels) ++size;
  // Less is seen of the inside: the next coarser mesh does.
  const Mesh* parts[] = {&walls_[size], &lip_, &walls_[size > 0 ? size - 1 : 0], &floor_};
  for (int part = 0; part < 4; ++part) {
    use_clay(part, pot, clip, pixel).set("soft_edges", soft ? 1.0f : 0.0f);
    parts[part]->draw();
  }
  if (pot.cut_away <= 0.001) return;
  glDisable(GL_CULL_FACE);
  const auto open = static_cast<float>(std::clamp(pot.cut_away, 0.0, 1.0));
  const float front = front_of(pot.camera);
  for (const int part : {4, 5}) {
    const Program& program = use_clay(part, pot, clip, pixel);
    program.set("soft_edges", soft ? 1.0f : 0.0f);
    for (const float face : {front, front - 0.5f * glm::pi<float>() * open}) {
      program.set("face_angle", face);
      section_.draw();
    }
  }
  glEnable(GL_CULL_FACE);
}

void Stage::draw_reflection(const view::PotView& pot, const glm::mat4& clip) {
  const Program& program = use_clay(0, pot, clip, pixel_size(pot.camera, 1.0));
  program.set("mirrored", 1.0f);
  glFrontFace(GL_CW);
  // Only what stands near the wheel head is seen in it.
  const double share = std::min(1.0, 0.12 / std::max(clay_.height(), 0.01));
  const int rows = std::max(1, static_cast<int>(kWalls[0].rows * share));
  walls_[0].draw_some(0, rows * kWalls[0].columns * 6);
  glFrontFace(GL_CCW);
}

void Stage::draw_hands(const view::PotView& pot, const glm::mat4& clip) {
  for (const HandView& hand : pot.hands)
    if (hand.present)
      tools_->draw(hand, clay_.levels(), clip,
                   [&](const Program& program) { set_light(program, pot.camera, clay_levels_); });
}

void Stage::draw_portrait(const Portrait& portrait) {
  const Levels& levels = portrait.levels;
  const view::Camera& camera = portrait.camera;
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  upload(levels, mesh_levels_);
  cast_shadow(levels.height, 0.0f, mesh_levels_, target);
  shadow_of_.reset();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const glm::mat4 clip = clip_of(camera);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  draw_ground(clip, false, levels.outer[0], 0.78f, glm::vec2(camera.width, camera.height));
  glEnable(GL_DEPTH_TEST);
  const Program& program = solid_program_;
  program.use();
  set_light(program, camera, mesh_levels_);
  program.set("clip_from_studio", clip);
  program.set("own_picture", kOwnPicture);
  program.set("height", static_cast<float>(levels.height));
  for (const Coat& coat : portrait.coats) {
    coat.picture.bind(kOwnPicture);
    portrait.mesh.draw_some(coat.first, coat.count);
  }
  glDisable(GL_DEPTH_TEST);
}

}  // namespace onggi::render
