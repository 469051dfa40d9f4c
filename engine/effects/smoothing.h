#pragma once

#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/wall_side.h"
#include "engine/effects/move_face.h"
#include "engine/effects/row_stage.h"

namespace onggi {

/// A rib or a sponge evens the wall that it goes along: throwing lines fade, and their clay fills
/// the grooves. The tools that do are those whose ToolShape::smooths.
struct SmoothingDef {
  double pace = 1e-4;  ///< D, m^2/s, 1e-6..1e-2: lines of width L fade at (2 pi / L)^2 D a second
                       ///< under the tool. Higher: gone in one turn.

  static constexpr const char* kName = "smoothing";
  static std::span<const DefField<SmoothingDef>> fields();
};

namespace effects {

/// Diffusion of R^2, whose integral over height is volume, along the wall: implicit, so that any
/// tick is stable, nothing gets larger than the largest or smaller than the least, and no clay is
/// lost. Allocates only when made; one thread.
class Smoothing : public KeepsNoRows {
 public:
  explicit Smoothing(int rows);

  static constexpr bool kAsksMoves = true;
  static bool wanted(const Effects& def);
  static Smoothing make(const Effects&, Clay& clay) { return Smoothing(clay.room()); }
  void run(const StageWork& work) noexcept;

  /// Stage 6.3: evens the elements that moved in this tick, and what lies between them up and down,
  /// of rows whose middles are from `bottom` to `top` (m). O(those).
  void even(const SmoothingDef& def, Clay& clay, WallSide side, double bottom, double top,
            double seconds) noexcept;

 private:
  std::vector<float> weight_;  // of the row: its height
  std::vector<float> flow_;    // to the row above, m
  std::vector<float> up_, inverse_;
  std::vector<float> change_;   // eight columns at once, a row after the other
  std::vector<double> gained_;  // sum of squares of radii, each row in this tick
  std::vector<float> extent_;   // largest, or inside smallest, radius written
};

}  // namespace effects
}  // namespace onggi
