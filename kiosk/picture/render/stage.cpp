#include "kiosk/picture/render/stage.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <string>

#include "kiosk/picture/render/shaders.h"
#include "kiosk/picture/render/skin_reader.h"
#include "kiosk/picture/render/stage_meshes.h"

namespace onggi::render {
namespace {

// Meshes of the walls, each with the pot's height in pixels up to which it is fine enough. Light
// and grooves come from the radius textures at every pixel, so a mesh only gives the outline: a
// chord of 6 pixels is within 0.2 of an arc of 25. Small triangles are expensive: a software
// rasterizer shades 4 x 4 pixels for each one that it touches.
struct Wall {
  int columns, rows;
  float most_pixels;
};
constexpr std::array<Wall, 4> kWalls{
    {{44, 48, 280.0f}, {60, 96, 580.0f}, {96, 192, 1200.0f}, {192, 400, 1e9f}}};
// Equally fine meshes for the part of the circle that faces the eye, if that is at most kFacing.
constexpr double kFacing = 0.6;
// More of the circle that shows a bead of 3 mm over the edge of a wall of 45 mm.
constexpr double kBeadsSeen = 0.12;
// Less of the inside is visible, so it has the next coarser mesh.
constexpr std::size_t inside_of(std::size_t wall) { return wall > 0 ? wall - 1 : 0; }
constexpr float kBeforeSection = 0.003f, kInk = 0.0002f;  // m
constexpr float kNarrowOpening = 5.0f;                    // texels
constexpr int facing_columns(int columns) { return static_cast<int>(kFacing * columns + 0.5); }
constexpr std::size_t kSectionPart = 4;
constexpr Wall kMirrored{44, 16, 1e9f};
constexpr double kMirroredHeight = 0.12;  // m
// For the lip, by its radius in pixels: it is an outline all round, some pixels wide.
constexpr std::array<Wall, 3> kLips{{{64, 6, 160.0f}, {96, 8, 370.0f}, {160, 12, 1e9f}}};
// For the wall's section, by the pot's height.
// Size of a mesh position, like a pixel of a screen, m.
constexpr float kReadPixel = 0.0005f;
constexpr int kRim = 96;  // corners of the wheel head

// Texture units.
constexpr int kOuter = 0, kInner = 1, kLevelsUnit = 2, kSky = 3, kGrain = 4, kShadow = 5,
              kRowAt = 6, kWetRows = 7, kTornAt = 8, kOwnPicture = 9, kAway = 10,
              kCoat = 11;  // and three more

glm::mat4 clip_of(const view::Camera& camera) {
  glm::mat4 view, projection;
  camera.matrices(&view[0][0], &projection[0][0]);
  return projection * view;
}

// Metres in one pixel at the axis.
float pixel_size(const view::Camera& camera, double scale) {
  return static_cast<float>(2.0 * camera.distance * std::tan(0.5 * camera.fov) /
                            (camera.height * scale));
}

// The texels that fingers may cover: left, low, right, high. Empty without a finger.
glm::ivec4 fingers_in(const view::PotView& pot, double scale, const Target& space) {
  glm::ivec4 part(space.width(), space.height(), 0, 0);
  for (const HandView& hand : pot.hands) {
    if (!hand.present || !ToolPainter::fades(hand)) continue;
    const auto at = pot.camera.project(hand.at);
    if (!at) return {0, 0, space.width(), space.height()};
    // Nearer than the axis it is drawn larger.
    const double x = at->first * scale,
                 y = (static_cast<double>(pot.camera.height) - at->second) * scale,
                 around = 1.5 * ToolPainter::reach(hand) / pixel_size(pot.camera, scale) + 2.0;
    part = {std::min(part.x, static_cast<int>(x - around)),
            std::min(part.y, static_cast<int>(y - around)),
            std::max(part.z, static_cast<int>(x + around)),
            std::max(part.w, static_cast<int>(y + around))};
  }
  return {std::max(part.x, 0), std::max(part.y, 0), std::min(part.z, space.width()),
          std::min(part.w, space.height())};
}

float size_of(const view::PotView& pot) {
  return static_cast<float>(std::clamp(pot.size, 0.5, 1.0));
}

// The angle about the axis that faces the camera.
float front_of(const view::Camera& camera) {
  return 0.5f * glm::pi<float>() - static_cast<float>(camera.azimuth);
}

// The angle of the cut-away.
float opening_of(const view::PotView& pot) {
  return 0.5f * glm::pi<float>() * static_cast<float>(std::clamp(pot.cut_away, 0.0, 1.0));
}

Opening cut_away(const view::PotView& pot) {
  const float open = opening_of(pot);
  return {front_of(pot.camera) - open, open};
}

template <std::size_t N>
std::size_t fine_enough(const std::array<Wall, N>& meshes, float pixels) {
  std::size_t size = 0;
  while (pixels > meshes[size].most_pixels) ++size;
  return size;
}

}  // namespace

Result<std::unique_ptr<Stage>> Stage::create() {
  std::unique_ptr<Stage> stage(new Stage);
  Result<void> fine;
  const auto keep = [&fine](auto& into, auto made) {
    if (!fine) return;
    if (made) {
      into = std::move(*made);
    } else {
      fine = tl::unexpected(made.error());
    }
  };
  keep(stage->clay_programs_, ClayPrograms::create());
  keep(stage->wheel_program_,
       Program::create("wheel", {k_common_glsl, k_light_glsl, k_wheel_glsl}));
  keep(stage->solid_program_,
       Program::create("solid", {k_common_glsl, k_light_glsl, k_solid_glsl}));
  keep(stage->tools_, ToolPainter::create());
  keep(stage->coil_, CoilPainter::create());
  keep(stage->soft_edges_, SoftEdges::create());
  keep(stage->edges_, Edges::create());
  keep(stage->backdrop_, Backdrop::create());
  if (!fine) return tl::unexpected(fine.error());
  for (std::size_t i = 0; i < kWalls.size(); ++i) {
    stage->walls_[i] = unit_grid(kWalls[i].columns, kWalls[i].rows);
    stage->facing_[i] = unit_grid(facing_columns(kWalls[i].columns), kWalls[i].rows);
    stage->sections_[i] = section_mesh(kWalls[i].rows);
  }
  for (std::size_t i = 0; i < kLips.size(); ++i)
    stage->lips_[i] = unit_grid(kLips[i].columns, kLips[i].rows);
  stage->mirrored_ = unit_grid(kMirrored.columns, kMirrored.rows);
  stage->floor_ = unit_grid(48, 3);
  stage->wheel_ = wheel_head_mesh(kRim);
  return stage;
}

void Stage::set_light(const Program& program, const view::Camera& camera, const Texture& levels) {
  studio_.light(program, kSky);
  levels.bind(kLevelsUnit);
  program.set("levels", kLevelsUnit);
  studio_.grain().bind(kGrain);
  program.set("grain", kGrain);
  backdrop_->shadow().bind(kShadow);
  program.set("shadow", kShadow);
  program.set("eye", vec(camera.eye()));
}

void Stage::prepare(const view::PotView& pot, const Quality& quality) {
  studio_.put_window(pot.window);
  clay_.refresh(clay_levels_);
  backdrop_->cast(Backdrop::Of::clay, clay_.levels(), clay_levels_, studio_,
                  pot.wheel ? static_cast<float>(pot.wheel_radius) : 0.0f, size_of(pot),
                  quality.shadow_apart);
  skin_.prepare(pot);
  coil_->prepare(pot, cut_away(pot));
  if (!pot.beside) return;
  upload(vessel_.levels, vessel_levels_);
  backdrop_->cast(Backdrop::Of::mesh, vessel_.levels, vessel_levels_, studio_, 0.0f, 1.0f, 0.0);
}

double Stage::shown_opening(const view::PotView& pot, double scale) const {
  const float texels = opening_of(pot) * static_cast<float>(clay_.max_radius()) * size_of(pot) /
                       pixel_size(pot.camera, scale);
  return texels < kNarrowOpening ? 0.0 : pot.cut_away;
}

float Stage::foot(const view::PotView& pot) const {
  return pot.wheel ? static_cast<float>(pot.wheel_radius) : size_of(pot) * clay_.levels().outer[0];
}

void Stage::draw_ground(const view::PotView& pot, const Texture& plaster,
                        const Backdrop::Extent& extent) {
  backdrop_->draw_ground(clip_of(pot.camera), plaster, extent, pot.wheel, foot(pot),
                         static_cast<float>(std::clamp(pot.opacity, 0.0, 1.0)));
}

void Stage::draw_pot(const view::PotView& pot, const Quality& quality, double scale,
                     const Target* space, BareDepths* bare) {
  const bool shown = !clay_.empty();
  glClearColor(0, 0, 0, 0);
  glClearStencil(0);
  // Clear the whole texture: drivers draw a scissored clear as a rectangle.
  glDisable(GL_SCISSOR_TEST);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  const glm::mat4 clip = clip_of(pot.camera);
  const float pixel = pixel_size(pot.camera, scale);

  // 1. The clay.
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  if (shown) {
    // The edges of a tear lie inside triangles, where only alpha can smooth them.
    const bool soft = clay_.tears().any() && quality.samples > 0;
    coat_.draw_fine(quality.samples > 0);
    if (soft) soft_edges_.begin();
    draw_clay(pot, clip, pixel, soft, quality.samples > 0);
    if (soft) soft_edges_.end();
    draw_coil(pot, clip);
  }
  // 2. The visible wheel head, and the pot mirrored in it.
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

  // 3. The vessel, both sides, because open scans show their inside.
  if (pot.beside) {
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    draw_model(vessel_, vessel_levels_, pot.beside->camera, pot.beside->angle);
    glEnable(GL_BLEND);
    glEnable(GL_CULL_FACE);
  }
  // 4. The tools, and the fingers, which fade into the air.
  draw_hands(pot, clip, false);
  if (bare != nullptr) {
    glDisable(GL_SCISSOR_TEST);
    bare->keep(*space, fingers_in(pot, scale, *space));
    glEnable(GL_SCISSOR_TEST);
  }
  draw_hands(pot, clip, true);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
}

void Stage::prepare_edges(const view::PotView& pot, double scale) {
  const glm::mat4 clip = clip_of(pot.camera);
  WallMesh wall;
  if (!clay_.empty()) {
    const DrawnWall drawn = drawn_wall(pot, pixel_size(pot.camera, scale));
    const Wall& mesh = kWalls[drawn.size];
    wall = {drawn.facing ? facing_columns(mesh.columns) : mesh.columns, mesh.rows,
            kWalls[inside_of(drawn.size)].rows, drawn.open_from + drawn.open_angle,
            2.0f * glm::pi<float>() - drawn.open_angle};
  }
  edges_->prepare(clay_, coat_, wall, vessel_edges_, cut_away(pot), pot, clip, scale);
  if (clay_.empty()) return;
  // As fine as the frame.
  use_clay(1, pot, clip, pixel_size(pot.camera, 1.0)).set("unrolled", LipStrip::kUnrolled);
  edges_->draw_lip();
}

void Stage::draw_edges(const view::PotView& pot, const Target& space, const BareDepths& bare,
                       const Texture& ground, int width, int height) {
  const auto opacity = static_cast<float>(std::clamp(pot.opacity, 0.0, 1.0));
  edges_->draw(space, bare, ground, opacity, width, height);
  if (clay_.empty() || pot.cut_away <= 0.001) return;
  const float pixel = pixel_size(pot.camera, 1.0);
  const Program& program = use_clay(kSectionPart, pot, clip_of(pot.camera), pixel);
  program.set("soft_edges", 0.0f);
  program.set("ink", kInk);
  // A finger is nearer than the section by more than the depths within a texel.
  float view[16], projection[16];
  pot.camera.matrices(view, projection);
  const auto metres = static_cast<float>(pot.camera.distance);
  const float hides = -0.5f * kBeforeSection * projection[14] / (metres * metres);
  program.set("onto", glm::vec4(width, height, hides, opacity));
  space.depth().bind(kAway);
  program.set("away", kAway);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  sections_[inside_of(drawn_wall(pot, pixel).size)].draw_times(2);
  glDisable(GL_BLEND);
}

void Stage::draw_wheel(const view::PotView& pot, const glm::mat4& clip, float pixel) {
  const Program& program = wheel_program_;
  glFrontFace(GL_CW);
  program.use();
  set_light(program, pot.camera, clay_levels_);
  program.set("clip_from_studio", clip);
  program.set("radius", static_cast<float>(pot.wheel_radius));
  program.set("table_y", Backdrop::kTable);
  program.set("reach", Backdrop::kReach);
  program.set("wheel_angle", static_cast<float>(pot.wheel_angle));
  program.set("wetness", static_cast<float>(pot.wetness));
  program.set("pixel", pixel);
  program.set("opened", static_cast<float>(pot.cut_away));
  wheel_.draw();
  glFrontFace(GL_CCW);
}

const Program& Stage::use_clay(std::size_t part, const view::PotView& pot, const glm::mat4& clip,
                               float pixel) {
  const bool torn = clay_.tears().any();
  const Program& program =
      clay_programs_.of({.part = part,
                         .skin = ClaySkin::of(pot),
                         .torn = torn,
                         .decorated = part == kSectionPart ? coat_.has_beads() : coat_.shown()});
  program.use();
  if (torn && ClayPrograms::tears(part)) {
    clay_.tears().texture().bind(kTornAt);
    program.set("torn_at", kTornAt);
    program.set("soft_edges", 0.0f);
  }
  set_clay(program, pot, clip, pixel);
  return program;
}

void Stage::set_clay(const Program& program, const view::PotView& pot, const glm::mat4& clip,
                     float pixel) {
  const float open = opening_of(pot);
  set_light(program, pot.camera, clay_levels_);
  // Compute everything at the thrown size. A shrunken pot is seen from farther away instead.
  const float size = size_of(pot);
  program.set("eye", vec(pot.camera.eye()) / size);
  clay_.outer().bind(kOuter);
  clay_.inner().bind(kInner);
  program.set("outer_radius", kOuter);
  program.set("inner_radius", kInner);
  program.set("widest", clay_.widest());
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
  // The cut-away opens like a door with its hinge at the visitor's right, from the front.
  program.set("open_from", front_of(pot.camera) - open);
  program.set("open_angle", open);
  program.set("front", front_of(pot.camera));
  program.set("opened", static_cast<float>(std::clamp(pot.cut_away, 0.0, 1.0)));
  program.set("mirrored", 0.0f);
  program.set("unrolled", glm::vec2(0.0f));
  program.set("share", 1.0f);
  program.set("pixel", pixel / size);
  program.set("wetness", static_cast<float>(pot.wetness));
  program.set("embers", static_cast<float>(std::clamp(pot.embers, 0.0, 1.0)));
  skin_.set(program, pot, kWetRows);
  if (coat_.shown()) coat_.set(program, pixel / size, kCoat);
}

std::vector<view::SkinPoint> Stage::read_skin(const ClayMesh& mesh,
                                              const std::optional<view::Glazing>& glazing) {
  if (clay_.empty()) return std::vector<view::SkinPoint>(mesh.faces.size());
  view::PotView pot;
  if (glazing) {
    pot.finish = view::Finish::fired;
    pot.glazing = *glazing;
  }
  clay_.refresh(clay_levels_);
  return read_surface(mesh, [&](std::size_t part) {
    const Program& program = clay_programs_.of(
        {.part = part, .skin = ClaySkin::of(pot), .decorated = coat_.shown(), .read = true});
    program.use();
    set_clay(program, pot, glm::mat4(1.0f), kReadPixel);
  });
}

Stage::DrawnWall Stage::drawn_wall(const view::PotView& pot, float pixel, bool fine) const {
  const Vec3 eye = (1.0 / static_cast<double>(size_of(pot))) * pot.camera.eye();
  std::size_t size = fine_enough(kWalls, static_cast<float>(clay_.height()) / pixel);
  if (fine && coat_.has_beads()) size = std::min(size + 1, kWalls.size() - 1);
  const double facing = clay_.facing(eye) + (coat_.has_beads() ? kBeadsSeen : 0.0);
  const float front = front_of(pot.camera);
  if (pot.cut_away <= 0.001 && facing <= kFacing) {
    // Skip parts that face away: the hidden gap of a cut-away.
    const float gap = 2.0f * glm::pi<float>() * (1.0f - static_cast<float>(kFacing));
    return {size, true, front + glm::pi<float>() - 0.5f * gap, gap};
  }
  const float open = opening_of(pot);
  return {size, false, front - open, open};
}

void Stage::draw_clay(const view::PotView& pot, const glm::mat4& clip, float pixel, bool soft,
                      bool whole_frame) {
  const auto use = [&](std::size_t part) -> const Program& {
    const Program& program = use_clay(part, pot, clip, pixel);
    program.set("soft_edges", soft ? 1.0f : 0.0f);
    return program;
  };
  const Vec3 eye = (1.0 / static_cast<double>(size_of(pot))) * pot.camera.eye();
  const DrawnWall wall = drawn_wall(pot, pixel, whole_frame);
  const Program& outside = use(0);
  outside.set("open_from", wall.open_from);
  outside.set("open_angle", wall.open_angle);
  (wall.facing ? facing_ : walls_)[wall.size].draw();
  use(1);
  // The round edges of a thick wall are a small part of its top.
  const bool thick = clay_.rim_wall() > 4.0 * static_cast<double>(clay_.lip());
  const std::size_t round =
      thick ? kLips.size() - 1 : fine_enough(kLips, static_cast<float>(clay_.max_radius()) / pixel);
  lips_[round].draw();
  // The inside down to the visible depth.
  const bool whole = pot.cut_away <= 0.001 && !clay_.tears().any();
  const double deep = whole ? clay_.seen_into(eye) : 1.0;
  const std::size_t coarse = inside_of(wall.size);
  const Wall& inner = kWalls[coarse];
  const int rows = std::min(inner.rows, 1 + static_cast<int>(std::ceil(deep * inner.rows)));
  use(2);
  walls_[coarse].draw_some(0, indices_of_rows(inner.columns, rows));
  if (deep >= 1.0) {
    use(3);
    floor_.draw();
  }
  if (pot.cut_away <= 0.001) return;
  glDisable(GL_CULL_FACE);
  const Program& section = use(kSectionPart);
  section.set("onto", glm::vec4(0.0f));
  // A texel is too wide for the line: draw_edges() draws it.
  section.set("ink", whole_frame ? kInk : 0.0f);
  sections_[coarse].draw_times(2);
  glEnable(GL_CULL_FACE);
}

void Stage::draw_coil(const view::PotView& pot, const glm::mat4& clip) {
  coil_->draw(pot, static_cast<float>(clay_.height()), clip, [&](const Program& program) {
    set_light(program, pot.camera, clay_levels_);
    skin_.set(program, pot, kWetRows);
  });
}

void Stage::draw_reflection(const view::PotView& pot, const glm::mat4& clip) {
  const Program& program = use_clay(0, pot, clip, pixel_size(pot.camera, 1.0));
  program.set("mirrored", 1.0f);
  glFrontFace(GL_CW);
  // The wheel head mirrors only what is near it.
  program.set("share",
              static_cast<float>(std::min(1.0, kMirroredHeight / std::max(clay_.height(), 0.01))));
  mirrored_.draw();
  glFrontFace(GL_CCW);
}

void Stage::draw_hands(const view::PotView& pot, const glm::mat4& clip, bool fading) {
  for (const HandView& hand : pot.hands)
    if (hand.present && ToolPainter::fades(hand) == fading)
      tools_->draw(hand, clay_.levels(), clip,
                   [&](const Program& program) { set_light(program, pot.camera, clay_levels_); });
}

void Stage::draw_vessel_ground(const view::PotView& pot, int width, int height) {
  if (!pot.beside || vessel_.coats.empty()) return;
  const glm::vec2 size(width, height);
  // It extends beyond the edge, because the middle of the outermost pixel is half a pixel away.
  backdrop_->draw_ground_layer(clip_of(pot.beside->camera), vessel_.levels.outer[0],
                               static_cast<float>(std::clamp(pot.opacity, 0.0, 1.0)), size,
                               glm::vec2(0.5f));
}

void Stage::draw_model(const Model& model, const Texture& levels, const view::Camera& camera,
                       double turned) {
  const Program& program = solid_program_;
  program.use();
  set_light(program, camera, levels);
  program.set("clip_from_studio", clip_of(camera));
  program.set("own_picture", kOwnPicture);
  program.set("height", static_cast<float>(model.levels.height));
  program.set("turned", static_cast<float>(turned));
  for (const Coat& coat : model.coats) {
    coat.picture.bind(kOwnPicture);
    model.mesh.draw_some(coat.first, coat.count);
  }
}

void Stage::draw_portrait(const Portrait& portrait) {
  const Levels& levels = portrait.model.levels;
  const view::Camera& camera = portrait.camera;
  upload(levels, mesh_levels_);
  // A separate picture that many screens show.
  studio_.put_window(false);
  backdrop_->cast(Backdrop::Of::mesh, levels, mesh_levels_, studio_, 0.0f, 1.0f, 0.0);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const glm::vec2 size(camera.width, camera.height);
  backdrop_->draw_ground_layer(clip_of(camera), levels.outer[0], 0.78f, size,
                               size * glm::vec2(0.28f, 0.14f));
  glEnable(GL_DEPTH_TEST);
  draw_model(portrait.model, mesh_levels_, camera, 0.0);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace onggi::render
