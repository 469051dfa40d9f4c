#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "engine/base/result.h"
#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/render/levels.h"
#include "kiosk/picture/render/studio.h"
#include "kiosk/picture/view/frame.h"

namespace onggi::render {

/// The surroundings of a vessel: the plaster, and the vessel's shadow on it. Both are drawn flat,
/// and only when they change. Also composes the 3-D picture over them.
class Backdrop {
 public:
  static Result<std::unique_ptr<Backdrop>> create();

  /// The height of the table below the wheel head's top, m, and the reach of the shadow's texture
  /// from the axis.
  static constexpr float kTable = -0.024f, kReach = 0.62f;

  /// What casts the shadow: the clay, or a mesh.
  enum class Of : std::uint8_t { clay, mesh };
  /// Casts the shadow of `levels`, with texture `light`, if it differs by more than `apart` metres
  /// from the last one of its kind. `wheel_radius` 0: no wheel head. `size` of the vessel: 1 if it
  /// has not shrunk. Leaves the bound target unchanged.
  void cast(Of of, const Levels& levels, const Texture& light, const Studio& studio,
            float wheel_radius, float size, double apart);
  /// The shadow from window and sky, on the plane of the wheel head and on that of the table.
  const Texture& shadow(Of of = Of::clay) const { return casts_[place(of)].shadow.color(); }
  /// Changes with every new shadow.
  std::uint64_t cast_serial(Of of = Of::clay) const { return casts_[place(of)].serial; }

  /// A rectangle on the ground, metres from the axis.
  struct Extent {
    float left = 0, back = 0, right = 0, front = 0;
    friend bool operator==(const Extent&, const Extent&) = default;
  };
  /// The area that a vessel of this height and width can darken. `window`: direction to it, unit.
  static Extent darkened(double height, double radius, bool wheel, float foot, glm::vec3 window);

  /// Draws the plaster over the whole bound target of this size, lit from that side.
  void draw_plaster(int width, int height, double window) const;
  /// Draws the ground within `extent` on the bound target, which has the size of `plaster`. `foot`:
  /// radius of the standing area, m.
  void draw_ground(const glm::mat4& clip, const Texture& plaster, const Extent& extent, bool wheel,
                   float foot, float opacity) const;
  /// Draws the shadow of a mesh on the ground as a layer over the existing picture. It fades over
  /// `edge` pixels towards the edges of a picture of `size`.
  void draw_ground_layer(const glm::mat4& clip, float foot, float strength, glm::vec2 size,
                         glm::vec2 edge) const;

  /// Composes the 3-D picture over `ground` into `box` (pixels of a width x height frame, from the
  /// top left) of the bound target. `space` may be smaller than the frame, unless it is
  /// multisampled.
  void lay(const Target& space, const Texture& ground, const view::Rect& box, float opacity,
           int width, int height) const;

 private:
  Backdrop() = default;
  void ground(const Program& program, Of of, const glm::mat4& clip, const Extent& extent,
              bool wheel, float foot, float strength) const;
  static std::size_t place(Of of) { return static_cast<std::size_t>(of); }

  Program shadow_program_, plaster_program_, ground_program_, layer_program_;
  std::array<Program, 2> lay_programs_;  // from one sample a pixel, from many
  Mesh quad_;
  struct Cast {
    Target shadow;
    std::optional<Levels> of;
    float wheel = 0, size = 1;
    double window = 0;
    std::uint64_t serial = 0;
  };
  std::array<Cast, 2> casts_;
};

}  // namespace onggi::render
