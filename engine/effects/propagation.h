#pragma once

#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/wall_side.h"
#include "engine/effects/column_kernels.h"
#include "engine/effects/move_face.h"
#include "engine/effects/row_stage.h"

namespace onggi {

/// Pressed clay drags the wall above and below it along, less with distance (Lee & Choi 2009).
/// Without it a tool leaves a sharp edge.
struct PropagationDef {
  double reach = 0.004;  ///< m, 0.0005..0.05: about a third of the motion follows at this distance,
                         ///< none at three times it. Higher: softer lines.

  static constexpr const char* kName = "propagation";
  static std::span<const DefField<PropagationDef>> fields();
};

namespace effects {

/// Drags the rows near those that moved. Allocates only when made; one thread.
class Propagation : public KeepsNoRows {
 public:
  explicit Propagation(int rows);

  static constexpr bool kAsksMoves = true;
  static bool wanted(const Effects& def);
  static Propagation make(const Effects&, Clay& clay) { return Propagation(clay.room()); }
  void run(const StageWork& work) noexcept;

  /// Stage 6.1. A row moves at most as far as the strongest pull near it, after fading. A row that
  /// moved that far by itself stays. `along`: see limits_of(). Adds what was dragged to the
  /// displacements. O(elements moved, and three reaches beyond).
  void drag(const PropagationDef& def, Clay& clay, WallSide side, double along) noexcept;

 private:
  // By row, from the lowest row that may be dragged.
  std::vector<float> fading_;  // from the row below
  std::vector<column_kernels::Give> give_;
  std::vector<float> more_;   // eight columns at once, row after row
  std::vector<double> lost_;  // sum of squares of radii, in this tick
  std::vector<float> outermost_, innermost_;
};

}  // namespace effects
}  // namespace onggi
