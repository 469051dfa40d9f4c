#pragma once

#include <vector>

#include "engine/surface/laws.h"
#include "kiosk/visit/decorating/touched_part.h"

namespace onggi::decorating {

/// Where slip was just laid it glistens, and dries within kDries. A stand-in: it dries evenly, all
/// round at one height at once, where a porous pot draws the water out of a thin coat first.
class WetSlip {
 public:
  static constexpr double kDries = 10.0;  ///< s
  static constexpr int kLevels = 96;

  /// True for a tool that lays slip, wet.
  static bool lays(const surface::Tool& tool);
  /// Slip was laid on `part` of `surface`. Allocates the first time.
  void lay(const surface::Surface& surface, const Part& part);
  void dry(double seconds);
  /// At kLevels even heights from the foot to the rim, 0 (dry) to 1; empty: all is dry.
  const std::vector<float>& by_height() const { return wet_; }

 private:
  std::vector<float> wet_;
};

}  // namespace onggi::decorating
