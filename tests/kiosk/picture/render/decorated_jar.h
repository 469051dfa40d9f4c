#pragma once

#include "engine/surface/laws.h"
#include "kiosk/collection/decoration/coat_picture.h"
#include "tests/kiosk/picture/render/studio_fixture.h"

namespace onggi::render::testing {

/// A jar of `height`, its surface, and the picture of what was done to it. Pigments: 0 white slip,
/// 1 dark slip, 2 cobalt.
struct DecoratedJar {
  explicit DecoratedJar(double height = 0.18, double grooves = 0.0002);

  /// `stroke`, `times` round the pot.
  void lay(const surface::Stroke& stroke, int times = 1);
  void lay(const surface::DipDef& dip) { lay({dip, {}, false}); }
  /// A tool's way through places (m along the outline, turns).
  surface::Stroke way(surface::Tool tool, const std::vector<std::array<double, 2>>& places) const;
  /// Once round, at a share of the outer wall's height.
  surface::Stroke ring(surface::Tool tool, double share) const;
  /// An area, its corners in mm round a middle: to the left as seen from outside, and up.
  surface::Stroke area(int pigment, double share, double turns,
                       const std::vector<std::array<double, 2>>& corners) const;
  /// From the foot along the outline, m.
  double along(double share) const;
  /// Draws everything anew, before or after the fire.
  const decoration::CoatPicture* draw(bool fired);

  ClayView clay;
  Profile profile;
  surface::Surface surface;
  decoration::CoatPicture picture;
};

surface::BrushDef brush_of(int pigment, double width);

}  // namespace onggi::render::testing
