#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/clay/clay_mesh.h"
#include "engine/profile/mesh.h"
#include "kiosk/picture/render/backdrop.h"
#include "kiosk/picture/render/clay_programs.h"
#include "kiosk/picture/render/clay_skin.h"
#include "kiosk/picture/render/clay_surface.h"
#include "kiosk/picture/render/coat_texture.h"
#include "kiosk/picture/render/coil_painter.h"
#include "kiosk/picture/render/edges.h"
#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/render/mesh_outline.h"
#include "kiosk/picture/render/portrait.h"
#include "kiosk/picture/render/soft_edges.h"
#include "kiosk/picture/render/studio.h"
#include "kiosk/picture/render/tool_painter.h"
#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/skin_point.h"

namespace onggi::render {

/// Picture quality. It never affects the engine's grid.
struct Quality {
  int samples = 4;         ///< Multisampling.
  bool reflection = true;  ///< Mirror the pot in the wheel head.
  /// The shadow is renewed when the clay has moved by this much, metres. Soft edges begin at 2.5
  /// mm.
  double shadow_apart = 0.0005;
};

/// Everything in 3-D: the clay, the wheel head, the tools, their light and shadow. Draws into the
/// bound target, over a transparent ground (premultiplied, display sRGB).
class Stage {
 public:
  static Result<std::unique_ptr<Stage>> create();

  ClaySurface& clay() { return clay_; }
  /// The decoration of the clay.
  CoatTexture& coat() { return coat_; }
  const Backdrop& backdrop() const { return *backdrop_; }
  /// pot.cut_away, or 0 where the opening is narrower than a few texels of a picture with one
  /// sample a pixel that is `scale` times the camera's size: it would be broken lines, which
  /// flicker.
  double shown_opening(const view::PotView& pot, double scale) const;
  /// Call before the others: uploads the changes of clay, light and water.
  void prepare(const view::PotView& pot, const Quality& quality);
  /// Draws the pot's shadow on `plaster` into the bound target of the same size.
  void draw_ground(const view::PotView& pot, const Texture& plaster,
                   const Backdrop::Extent& extent);
  /// Radius of the wheel head or the pot's foot on the ground, metres.
  float foot(const view::PotView& pot) const;
  /// Sets the vessel beside the pot; none while a pot is drawn alone.
  void show_vessel(Model vessel, MeshEdges edges) {
    vessel_ = std::move(vessel);
    vessel_edges_ = std::move(edges);
  }
  const Model& vessel() const { return vessel_; }
  /// Draws the vessel's shadow on a ground of this size. Call prepare() first.
  void draw_vessel_ground(const view::PotView& pot, int width, int height);
  /// Draws the pot and the vessel beside it into the bound target, which is `scale` times the
  /// camera's size. `space` is that target if its edges will be drawn, and `bare` is for them.
  void draw_pot(const view::PotView& pot, const Quality& quality, double scale,
                const Target* space = nullptr, BareDepths* bare = nullptr);
  /// Call before draw_pot() with one sample a pixel, if its edges are to be smooth: finds them, and
  /// draws the lip for them. Leaves another target bound.
  void prepare_edges(const view::PotView& pot, double scale);
  /// Smooths the edges of a picture in `space` that is laid over `ground` in the bound frame, and
  /// draws a section as finely as the frame.
  void draw_edges(const view::PotView& pot, const Target& space, const BareDepths& bare,
                  const Texture& ground, int width, int height);
  void draw_portrait(const Portrait& portrait);
  /// The clay's surface at the positions of `mesh`, which must be the clay's own: dry, or fired in
  /// `glazing`. Ignores the bound target, and leaves another one bound.
  std::vector<view::SkinPoint> read_skin(const ClayMesh& mesh,
                                         const std::optional<view::Glazing>& glazing);
  /// For staff, each once.
  std::vector<std::string> remarks() { return clay_programs_.remarks(); }

 private:
  Stage() = default;
  void set_light(const Program& program, const view::Camera& camera, const Texture& levels);
  void draw_wheel(const view::PotView& pot, const glm::mat4& clip, float pixel);
  /// The outer wall's mesh for this picture: all round, or the part that faces the eye. `fine`: no
  /// ribbon smooths its outline, so beads have a finer one.
  struct DrawnWall {
    std::size_t size = 0;
    bool facing = false;
    float open_from = 0, open_angle = 0;
  };
  DrawnWall drawn_wall(const view::PotView& pot, float pixel, bool fine = false) const;
  void draw_clay(const view::PotView& pot, const glm::mat4& clip, float pixel, bool soft,
                 bool whole_frame);
  void draw_coil(const view::PotView& pot, const glm::mat4& clip);
  void draw_reflection(const view::PotView& pot, const glm::mat4& clip);
  void draw_model(const Model& model, const Texture& levels, const view::Camera& camera,
                  double turned);
  void draw_hands(const view::PotView& pot, const glm::mat4& clip, bool fading);
  /// Prepares the current program of clay.glsl, except for mesh and tears.
  void set_clay(const Program& program, const view::PotView& pot, const glm::mat4& clip,
                float pixel);
  const Program& use_clay(std::size_t part, const view::PotView& pot, const glm::mat4& clip,
                          float pixel);

  Studio studio_;
  ClaySurface clay_;
  ClaySkin skin_;
  CoatTexture coat_;
  ClayPrograms clay_programs_;
  std::unique_ptr<ToolPainter> tools_;
  std::unique_ptr<CoilPainter> coil_;
  std::unique_ptr<Backdrop> backdrop_;
  SoftEdges soft_edges_;
  std::unique_ptr<Edges> edges_;
  Program wheel_program_, solid_program_;
  std::array<Mesh, 4> walls_, facing_;
  std::array<Mesh, 3> lips_;
  std::array<Mesh, 4> sections_;  // with the rows of walls_, so that no gap shows between them
  Mesh mirrored_, floor_, wheel_;
  Texture clay_levels_, mesh_levels_, vessel_levels_;
  Model vessel_;
  MeshEdges vessel_edges_;
};

}  // namespace onggi::render
