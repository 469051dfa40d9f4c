#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "engine/clay/clay.h"
#include "engine/clay/history.h"
#include "engine/clay/wall_side.h"
#include "engine/math/hash.h"
#include "engine/math/vec.h"

namespace onggi {
struct Effects;
}

namespace onggi::effects {

class Moisture;
class Volume;

inline constexpr std::size_t kMostHands = 2;

/// A hand as contact left it.
struct HandThere {
  Vec3 at;               ///< Clay frame, in the middle of the tick, m.
  double normal = 0.0;   ///< N; 0 where it presses nothing.
  bool on_wall = false;  ///< Not clear, nor on the rim or the floor.
  WallSide side = WallSide::outside;
  double along = 0.0;    ///< Share of its press with which the wall gives way as a whole.
  double smooths = 0.0;  ///< How far up and down it evens the wall, m; 0 where it does not.
};

/// What a tick brings the stages.
struct RowTick {
  Moisture* moisture = nullptr;      ///< Null where it is absent.
  clay::History* history = nullptr;  ///< Likewise.
  double wheel_speed = 0.0;          ///< Of the clay, rad/s.
  double seconds = 0.0;
  bool touched = false;    ///< A hand pressed clay.
  std::uint64_t step = 0;  ///< clay::History::depth(); 0 where nothing can be taken back.
  std::array<HandThere, kMostHands> hand{};
};

/// What a stage works with in one tick.
struct StageWork {
  const Effects& def;
  Clay& clay;
  const RowTick& tick;
  Volume* volume = nullptr;           ///< Null where it is absent.
  WallSide side = WallSide::outside;  ///< The face whose presses have their turn,
  double side_seconds = 0.0;          ///< and the time since it had its last one.
  bool laid = false;                  ///< A lump was put on since the last tick.

  /// Share with which the wall gives way as a whole where its face `face` is moved by no press of
  /// its own: as under the hand on that face, and as one that nobody holds where there is no hand.
  double along(WallSide face) const noexcept;
};

/// Row `row` was divided: its upper half is row `row` + 1. Stored (Clay::stored): `from`, `to`.
struct RowDivided {
  int row = 0;
  int from = 0, to = 0;
};
/// Row `row` has taken up the row above it, which was stored at `to` and held `upper` m^3.
struct RowsJoined {
  int row = 0;
  int from = 0, to = 0;
  double upper = 0.0;
};
/// How the clay came to be laid anew.
struct Laid {
  bool fresh = false;      ///< A fresh lump; else the clay as it once was.
  std::uint64_t step = 0;  ///< clay::History::depth(), of the step in which it was laid, or that
                           ///< was taken back with all after it.
};

/// A stage of the pipeline that works on rows after the press (engine/docs/pipeline.md, stage 6).
/// Every one says for itself what each of these means to it, so that none can be forgotten. Nothing
/// but make() allocates.
template <class S>
concept Stage = requires(S& stage, const S& as_it_is, const Effects& def, Clay& clay,
                         const StageWork& work, StateHash& hash) {
  { S::kAsksMoves } -> std::convertible_to<bool>;  ///< It asks what contact moved in the tick.
  { S::wanted(def) } -> std::same_as<bool>;        ///< The scene has it.
  { S::make(def, clay) } -> std::same_as<S>;
  { stage.run(work) }
  noexcept;
  { stage.row_divided(clay, RowDivided{}) }
  noexcept;
  { stage.rows_joined(clay, RowsJoined{}) }
  noexcept;
  { stage.forget(clay, Laid{}) }
  noexcept;  ///< The clay was laid anew.
  as_it_is.add_to(hash, clay);
};
// A stage may have more, which it is then asked for:
//   static void lay_row(const Effects&, Clay&, int j)       how row j of a fresh lump is laid
//   bool measure_some(Clay&, int element_budget) noexcept   what it needs of a laid clay; true:
//   done bool loaded(int stored) const                           this stored row may not be joined
//   now

/// For a stage that keeps nothing of the rows from one tick to the next.
struct KeepsNoRows {
  void row_divided(const Clay&, const RowDivided&) noexcept {}
  void rows_joined(const Clay&, const RowsJoined&) noexcept {}
  void forget(Clay&, const Laid&) noexcept {}
  void add_to(StateHash&, Clay&) const {}
};

/// Stages in the pipeline's order.
template <Stage... S>
struct Stages {
  template <template <class...> class All>
  using in = All<S...>;
};

}  // namespace onggi::effects
