#pragma once

#include <span>
#include <string_view>

#include "engine/base/def_field.h"

namespace onggi {

/// The end of a visit: the pot dries, is fired, and comes out smaller under its glaze. Nothing of
/// it runs on the tick. Each default is stoneware's.
struct KilnDef {
  double drying_shrinkage = 0.0625;  ///< s_d, 0..0.15: share of every length lost as water goes.
  double firing_shrinkage = 0.0666;  ///< s_f, 0..0.2: share of what is left that firing takes.
                                     ///< Higher: denser ware, a smaller pot.
  double glaze_thickness = 0.0005;  ///< m, 0..0.002: of the glass. Thicker: deeper colour. 0 leaves
                                    ///< the pot bare.

  static constexpr const char* kName = "kiln";
  static std::span<const DefField<KilnDef>> fields();
};

/// A clay as it is bought, for a scene's `body`: its two shrinkages.
struct ClayBody {
  std::string_view name;  ///< "stoneware"
  double drying_shrinkage = 0.0, firing_shrinkage = 0.0;
};
/// Earthenware, stoneware, porcelain: the middle of what is published for each
/// (engine/docs/effects.md).
std::span<const ClayBody> clay_bodies();
/// nullptr where there is none of this name.
const ClayBody* find_clay_body(std::string_view name);

/// Where a pot is on its way from the wheel to the shelf.
struct Firing {
  double dried = 0.0;  ///< 0 as thrown .. 1 bone dry.
  double fired = 0.0;  ///< 0 unfired .. 1 out of the kiln.
};

/// What is left of a length, 0..1: (1 - s_d dried)(1 - s_f fired). Falls with either. The two are
/// multiplied, as the kiln shrinks what drying has left: 6.25 % and 6.66 % are 12.5 %.
double size_after(const KilnDef& def, const Firing& at) noexcept;

}  // namespace onggi
