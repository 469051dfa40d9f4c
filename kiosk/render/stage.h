#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "engine/base/result.h"
#include "engine/profile/mesh.h"
#include "kiosk/render/clay_skin.h"
#include "kiosk/render/clay_surface.h"
#include "kiosk/render/gl.h"
#include "kiosk/render/portrait.h"
#include "kiosk/render/studio.h"
#include "kiosk/render/tool_painter.h"
#include "kiosk/view/frame.h"

namespace onggi::render {

/// How finely the stage is drawn. Never touches the engine's grid.
struct Quality {
  int samples = 4;         ///< Multisampling.
  bool reflection = true;  ///< The pot mirrored in the wheel head.
  /// How much the clay may have moved since its shadow was cast, metres. Soft edges begin at 2.5
  /// mm.
  double shadow_apart = 0.0;
};

/// Everything in space: the clay, the wheel head, the tools, their light and shadow. Draws into the
/// bound target, over a transparent ground (premultiplied, display sRGB).
class Stage {
 public:
  static Result<std::unique_ptr<Stage>> create();

  ClaySurface& clay() { return clay_; }
  /// Draws the pot into the bound target, which is `scale` times the camera's size.
  void draw_pot(const view::PotView& pot, const Quality& quality, double scale);
  void draw_portrait(const Portrait& portrait);
  /// The plaster, over the whole bound target of this size.
  void draw_plaster(int width, int height);

 private:
  Stage() = default;
  /// `wheel_radius` 0: no wheel head.
  /// `size` of the vessel, 1 where it has not shrunk.
  void cast_shadow(double height, float wheel_radius, const Texture& levels, GLint back_to,
                   float size = 1.0f);
  void set_light(const Program& program, const view::Camera& camera, const Texture& levels);
  void draw_ground(const glm::mat4& clip, bool wheel, float foot, float strength,
                   glm::vec2 faded_size = glm::vec2(0.0f));
  void draw_wheel(const view::PotView& pot, const glm::mat4& clip, float pixel);
  void draw_clay(const view::PotView& pot, const glm::mat4& clip, float pixel, bool soft);
  void draw_reflection(const view::PotView& pot, const glm::mat4& clip);
  void draw_hands(const view::PotView& pot, const glm::mat4& clip);
  const Program& use_clay(int part, const view::PotView& pot, const glm::mat4& clip, float pixel);

  Studio studio_;
  ClaySurface clay_;
  ClaySkin skin_;
  std::array<std::array<Program, 6>, ClaySkin::kSkins> clay_programs_,
      torn_programs_;  // by skin and part of clay.glsl; only walls and lips tear
  std::unique_ptr<ToolPainter> tools_;
  std::array<Program, 2> wheel_programs_;
  Program solid_program_, shadow_program_, ground_program_, plaster_program_;
  std::array<Mesh, 4> walls_;
  Mesh quad_, lip_, floor_, section_, disc_, edge_;
  Texture clay_levels_, mesh_levels_;
  Target shadow_;
  std::optional<Levels> shadow_of_;  // nothing: another mesh's is in it
  float shadow_wheel_ = 0, shadow_size_ = 1;
};

}  // namespace onggi::render
