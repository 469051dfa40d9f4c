#pragma once

#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/wall_side.h"
#include "engine/effects/move_face.h"
#include "engine/effects/row_stage.h"

namespace onggi {

/// A rib or sponge smooths the wall that it passes: throwing lines fade, and their clay fills the
/// grooves. Tools with ToolShape::smooths do this.
struct SmoothingDef {
  double pace = 1e-4;  ///< D, m^2/s, 1e-6..1e-2: under the tool, lines of width L fade at (2 pi /
                       ///< L)^2 D a second. Higher: gone in one turn.

  static constexpr const char* kName = "smoothing";
  static std::span<const DefField<SmoothingDef>> fields();
};

namespace effects {

/// Diffusion along the wall of R^2, whose integral over height is volume. Implicit: stable at any
/// tick, makes no new extremes, and loses no clay. Allocates only when made; one thread.
class Smoothing : public KeepsNoRows {
 public:
  explicit Smoothing(int rows);

  static constexpr bool kAsksMoves = true;
  static bool wanted(const Effects& def);
  static Smoothing make(const Effects&, Clay& clay) { return Smoothing(clay.room()); }
  void run(const StageWork& work) noexcept;

  /// Stage 6.3: smooths the elements that moved in this tick and the elements between them up and
  /// down, in rows whose middles lie from `bottom` to `top` (m). O(those elements).
  void even(const SmoothingDef& def, Clay& clay, WallSide side, double bottom, double top,
            double seconds) noexcept;

 private:
  std::vector<float> weight_;  // of the row: its height
  std::vector<float> flow_;    // to the row above, m
  std::vector<float> up_, inverse_;
  std::vector<float> change_;   // eight columns at once, row after row
  std::vector<double> gained_;  // by row: sum of squares of radii in this tick
  std::vector<float> extent_;   // largest radius written, or inside the smallest
};

}  // namespace effects
}  // namespace onggi
