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

/// What a vessel stands in: the plaster, and its shadow on it, which are drawn flat and anew only
/// where they have changed; and how the picture in space is laid over them.
class Backdrop {
 public:
  static Result<std::unique_ptr<Backdrop>> create();

  /// The height of the table under the wheel head's top, m, and how far from the axis the shadow's
  /// texture reaches.
  static constexpr float kTable = -0.024f, kReach = 0.62f;

  /// Whose shadow: the clay's, or a mesh's.
  enum class Of : std::uint8_t { clay, mesh };
  /// Casts the shadow of `levels`, whose texture is `light`, where it is more than `apart` metres
  /// from the one that was cast last of its kind. `wheel_radius` 0: no wheel head; `size` of the
  /// vessel, 1 where it has not shrunk. Leaves the bound target as it was.
  void cast(Of of, const Levels& levels, const Texture& light, const Studio& studio,
            float wheel_radius, float size, double apart);
  /// Of window and sky, on the wheel head's plane and on the table's.
  const Texture& shadow(Of of = Of::clay) const { return casts_[place(of)].shadow.color(); }
  /// Another number with every shadow that is cast.
  std::uint64_t cast_serial(Of of = Of::clay) const { return casts_[place(of)].serial; }

  /// A rectangle on the ground, metres from the axis.
  struct Extent {
    float left = 0, back = 0, right = 0, front = 0;
    friend bool operator==(const Extent&, const Extent&) = default;
  };
  /// Outside of it no vessel as tall and as wide darkens the ground. `window`: towards it, unit.
  static Extent darkened(double height, double radius, bool wheel, float foot, glm::vec3 window);

  /// The plaster, over the whole bound target of this size, lit from there.
  void draw_plaster(int width, int height, bool window_right) const;
  /// The ground within `extent`, where it lies on the bound target, which has the size of
  /// `plaster`. `foot`: radius of what stands on it, m.
  void draw_ground(const glm::mat4& clip, const Texture& plaster, const Extent& extent, bool wheel,
                   float foot, float opacity) const;
  /// What the ground loses to a mesh, as a layer over what is there, faded over `edge` pixels to
  /// the edges of a picture of `size`.
  void draw_ground_layer(const glm::mat4& clip, float foot, float strength, glm::vec2 size,
                         glm::vec2 edge) const;

  /// `box` (pixels of a width x height frame, from the top left) of the bound target becomes the
  /// picture in space over `ground`. `space` may be smaller than the frame; where it has samples it
  /// may not.
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
    bool window_right = false;
    std::uint64_t serial = 0;
  };
  std::array<Cast, 2> casts_;
};

}  // namespace onggi::render
