#pragma once

#include <array>
#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/wall_side.h"
#include "engine/effects/move_face.h"
#include "engine/effects/round.h"
#include "engine/effects/row_stage.h"
#include "engine/math/hash.h"

namespace onggi {

/// Elastic share of a press, which comes back when the tool moves on (standard linear solid: the
/// contact's relaxation in series with this spring and its damper).
struct SpringbackDef {
  double share = 0.15;  ///< Share of a press that comes back, 0..0.5. Higher: leathery; lines need
                        ///< deeper presses.
  double time = 0.2;    ///< s, 0.01..10: time in which two thirds of that comes back.

  static constexpr const char* kName = "springback";
  static std::span<const DefField<SpringbackDef>> fields();
};

namespace effects {

/// How far each element still has to come back. Allocates only when made; one thread.
class Springback {
 public:
  explicit Springback(const Clay& clay);

  static constexpr bool kAsksMoves = true;
  static bool wanted(const Effects& def);
  static Springback make(const Effects&, Clay& clay) { return Springback(clay); }
  void run(const StageWork& work) noexcept;

  /// Stage 6.2: stores the share of this tick's moves that will come back. O(elements moved).
  void load(const SpringbackDef& def, Clay& clay, WallSide side) noexcept;
  /// Stage 6.2: lets loaded rows come back. Rows take turns, eight in SpringbackDef::time, fewer on
  /// the finest grids (Round::lasting). Each turn is an exact exponential over the time since the
  /// last one. No row goes beyond where it was pressed from. `along`: see limits_of(). Asleep when
  /// nothing is loaded.
  void come_back(const SpringbackDef& def, Clay& clay, double seconds, double along) noexcept;
  /// True if a stored row still has to come back; it may then not be joined.
  bool loaded(int stored) const {
    const auto n = static_cast<std::size_t>(stored);
    return face_[0].rows[n] != 0 || face_[1].rows[n] != 0;
  }
  void row_added(const Clay&, const RowAdded&) noexcept {}
  /// The upper half of a loaded row is loaded too.
  void row_divided(const Clay&, const RowDivided& divided) noexcept;
  void rows_joined(const Clay&, const RowsJoined&) noexcept {}  // loaded rows are never joined
  /// Clears all loads. O(loaded rows).
  void forget(Clay&, const Laid&) noexcept;

  bool asleep() const { return loaded_rows_ == 0; }
  void add_to(StateHash& hash, Clay&) const;

 private:
  struct Face {                      // by stored row
    std::vector<float> left;         // m, >= 0
    std::vector<double> seen;        // when each row last came back
    std::vector<std::uint8_t> rows;  // 1: something is left
  };
  Face& face(WallSide side) { return face_[side == WallSide::inside ? 1 : 0]; }
  void row_back(Clay& clay, WallSide side, int j, double time, double along) noexcept;

  std::array<Face, 2> face_;
  std::size_t stride_;
  std::size_t room_;
  int next_ = 0;  // row whose turn is next
  Round round_;
  double whole_ = 0.0;  // s, length of this round
  int loaded_rows_ = 0;
  double now_ = 0.0;
};

}  // namespace effects
}  // namespace onggi
