#pragma once

#include <optional>
#include <utility>

#include "engine/math/vec.h"
#include "kiosk/picture/view/rect.h"

namespace onggi::view {

/// A pinhole camera in the studio frame (y up, z towards the visitor), looking along -z and a
/// little down. The vertical field of view spans `height` pixels; the image centre is at `centre`.
struct Camera {
  int width = 1280, height = 720;        ///< Pixels of the whole frame.
  float centre_x = 640, centre_y = 360;  ///< Place of `target`, pixels from the top left.
  Vec3 target{0, 0.1, 0};                ///< Looked at, metres.
  double distance = 0.9;                 ///< From `target`, metres.
  double elevation = 0.25;               ///< Radians above the horizon.
  double azimuth = 0.0;                  ///< Radians about the axis.
  double fov = 0.42;                     ///< Vertical, radians.

  friend bool operator==(const Camera&, const Camera&) = default;
  Vec3 eye() const;
  /// Right, up and backward (towards the eye) unit vectors.
  void basis(Vec3& right, Vec3& up, Vec3& back) const;
  /// The pixel of a point; nothing if it is behind the eye.
  std::optional<std::pair<float, float>> project(Vec3 p) const;
  /// The point on the vertical plane through the axis that faces the camera, under a pixel:
  /// x = signed distance right of the axis, y = height, metres.
  Vec2 on_axis_plane(float px, float py) const;
  /// The point at the height `level` (m), under a pixel; nothing if the eye looks past it.
  std::optional<Vec3> on_level(float px, float py, double level) const;
  /// Column-major view and projection for OpenGL clip space (the shift included).
  void matrices(float view[16], float projection[16]) const;
};

/// A camera that shows a pot of `pot_height` and `pot_radius` (metres) inside `box` pixels, seen
/// slightly from above.
Camera frame_pot(int width, int height, const Rect& box, double pot_height, double pot_radius);

}  // namespace onggi::view
