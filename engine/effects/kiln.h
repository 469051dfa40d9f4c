#pragma once

#include <span>
#include <string_view>

#include "engine/base/def_field.h"

namespace onggi {

/// The end of a visit: the pot dries, is fired, and comes out smaller under its glaze. Nothing runs
/// on the tick. Defaults are stoneware's.
struct KilnDef {
  double drying_shrinkage = 0.0625;  ///< s_d, 0..0.15: share of every length lost in drying.
  /// s_f, 0..0.2: share of the remaining length lost in firing. Higher: denser ware.
  double firing_shrinkage = 0.0666;
  double glaze_thickness = 0.0005;  ///< m, 0..0.002: thickness of the glass. Thicker: deeper
                                    ///< colour. 0: bare pot.

  static constexpr const char* kName = "kiln";
  static std::span<const DefField<KilnDef>> fields();
};

/// A clay body for a scene's `body` key: its two shrinkages.
struct ClayBody {
  std::string_view name;  ///< "stoneware"
  double drying_shrinkage = 0.0, firing_shrinkage = 0.0;
};
/// Earthenware, stoneware, porcelain: the middle of what is published for each
/// (engine/docs/effects.md).
std::span<const ClayBody> clay_bodies();
/// nullptr if there is no body of this name.
const ClayBody* find_clay_body(std::string_view name);

/// How far a pot is dried and fired.
struct Firing {
  double dried = 0.0;  ///< 0 as thrown .. 1 bone dry.
  double fired = 0.0;  ///< 0 unfired .. 1 out of the kiln.
};

/// The remaining share of a length, 0..1: (1 - s_d dried)(1 - s_f fired). The two multiply, because
/// the kiln shrinks what drying has left: 6.25 % and 6.66 % are 12.5 %.
double size_after(const KilnDef& def, const Firing& at) noexcept;

}  // namespace onggi
