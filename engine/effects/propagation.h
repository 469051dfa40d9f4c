#pragma once

#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/wall_side.h"
#include "engine/effects/column_kernels.h"
#include "engine/effects/move_face.h"
#include "engine/effects/row_stage.h"

namespace onggi {

/// Clay hangs together: what is pressed drags the wall above and below it along, less with distance
/// (Lee & Choi 2009). Without it a tool's edge leaves an edge.
struct PropagationDef {
  double reach = 0.004;  ///< m, 0.0005..0.05: at this distance about a third follows, at three
                         ///< times this nothing. Higher: softer lines.

  static constexpr const char* kName = "propagation";
  static std::span<const DefField<PropagationDef>> fields();
};

namespace effects {

/// Drags the rows about those that moved. Allocates only when made; one thread.
class Propagation : public KeepsNoRows {
 public:
  explicit Propagation(int rows);

  static constexpr bool kAsksMoves = true;
  static bool wanted(const Effects& def);
  static Propagation make(const Effects&, Clay& clay) { return Propagation(clay.room()); }
  void run(const StageWork& work) noexcept;

  /// Stage 6.1: no row is moved by more than the strongest of those about it, times its share; one
  /// that moved that far by itself is left alone. `along`: see limits_of(). The displacements grow
  /// by what was dragged. O(elements moved, and three reaches beyond).
  void drag(const PropagationDef& def, Clay& clay, WallSide side, double along) noexcept;

 private:
  // By row, from the lowest that may be dragged.
  std::vector<float> fading_;  // from the row below
  std::vector<column_kernels::Give> give_;
  std::vector<float> more_;   // eight columns at once, a row after the other
  std::vector<double> lost_;  // sum of squares of radii, in this tick
  std::vector<float> outermost_, innermost_;
};

}  // namespace effects
}  // namespace onggi
