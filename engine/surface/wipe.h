#pragma once

#include <span>

#include "engine/base/def_field.h"
#include "engine/surface/lay.h"
#include "engine/surface/station.h"

namespace onggi::surface {

/// A fingertip, a thumb's knuckle or a fist in wet glaze (hwanchigi): the glaze goes to two ridges
/// beside the tool. None is lost. What has dried stays.
struct WipeDef {
  double width = 0.012;  ///< m, 0.006..0.018 on a pot of full size, 0.002..0.03 here.
  double leaves = 2e-5;  ///< Film under the finger, m, 0..2e-4.
  double ridge = 3e-4;   ///< Mean height of the ridges over the glaze, m, 5e-5..5e-4.
  double wet_time =
      60.0;  ///< Until the glaze is dry, s, 1..3600: 30 on fired clay, minutes on raw.

  static constexpr const char* kName = "wipe";
  static std::span<const DefField<WipeDef>> fields();
};

/// Wipes along `stations`. `def` and `stations` are valid (laws.h).
Work wipe(Surface& surface, const WipeDef& def, std::span<const Station> stations);

}  // namespace onggi::surface
