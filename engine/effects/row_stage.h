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

class Building;
class Moisture;
class Prints;
class Volume;

inline constexpr std::size_t kMostHands = 2;

/// A hand after contact.
struct HandThere {
  Vec3 at;               ///< Clay frame, in the middle of the tick, m.
  double normal = 0.0;   ///< N; 0 if it presses nothing.
  bool on_wall = false;  ///< Touches the wall: not clear, not on the rim or the floor.
  WallSide side = WallSide::outside;
  double along = 0.0;    ///< Share of its press by which the wall moves as a whole.
  double smooths = 0.0;  ///< How far up and down it smooths the wall, m; 0 if it does not.
};

/// A hand strikes the wall with a paddle.
struct Blow {
  bool lands = false;  ///< In this tick.
  Vec3 at;             ///< Where, clay frame, m.
  WallSide side = WallSide::outside;
  double ball = 0.0;  ///< m: radius of the hand's ball, at `at`.
  // Shares of BeatingDef::energy, 0..1: spent on clay between paddle and anvil (or hand), and on
  double squeezes = 0.0;
  double moves = 0.0;  // moving the wall away from `side`; less than 0: towards it.
  bool anvil = false;  ///< What holds against it is an anvil, not a hand.
  bool left = false;   ///< It comes to the left of the axis, as the visitor at +z sees the wheel.
};

/// A tick's input to the stages.
struct RowTick {
  Moisture* moisture = nullptr;      ///< Null if absent.
  clay::History* history = nullptr;  ///< Null if absent.
  double wheel_speed = 0.0;          ///< Of the clay, rad/s.
  double seconds = 0.0;
  bool touched = false;    ///< A hand pressed clay.
  std::uint64_t step = 0;  ///< clay::History::depth(); 0 without undo.
  std::array<HandThere, kMostHands> hand{};
  std::array<Blow, kMostHands> blow{};
};

/// What a stage works with in one tick.
struct StageWork {
  const Effects& def;
  Clay& clay;
  const RowTick& tick;
  Volume* volume = nullptr;           ///< Null if absent,
  Building* building = nullptr;       ///< and this too.
  WallSide side = WallSide::outside;  ///< The face whose turn it is,
  double side_seconds = 0.0;          ///< and the time since its last turn.
  bool laid = false;                  ///< A lump was laid since the last tick.
  Prints* prints = nullptr;           ///< Null if absent.

  /// Share by which the wall moves as a whole where face `face` moves without a press of its own:
  /// as under the hand on that face, or, without a hand there, as a wall that nobody holds.
  double along(WallSide face) const noexcept;
};

/// Row `row` was divided: its upper half is row `row` + 1. `from`, `to`: their stored rows
/// (Clay::stored).
struct RowDivided {
  int row = 0;
  int from = 0, to = 0;
};
/// Row `row` took up the row above it, which was stored at `to` and held `upper` m^3.
struct RowsJoined {
  int row = 0;
  int from = 0, to = 0;
  double upper = 0.0;
};
/// Row `row`, stored at `to`, was added at the top with new clay of `volume` m^3.
struct RowAdded {
  int row = 0;
  int to = 0;
  double volume = 0.0;
};
/// Why the clay was laid anew.
struct Laid {
  bool fresh = false;      ///< True for a fresh lump; false for undo.
  std::uint64_t step = 0;  ///< clay::History::depth() of the step in which it was laid, or of the
                           ///< earliest step that was taken back.
};

/// A stage of the pipeline that works on rows after the press (engine/docs/pipeline.md, stage 6).
/// Every stage must define each of these, so that none is forgotten. Only make() allocates.
template <class S>
concept Stage = requires(S& stage, const S& as_it_is, const Effects& def, Clay& clay,
                         const StageWork& work, StateHash& hash) {
  { S::kAsksMoves } -> std::convertible_to<bool>;  ///< It reads what contact moved in the tick.
  { S::wanted(def) } -> std::same_as<bool>;        ///< The scene has it.
  { S::make(def, clay) } -> std::same_as<S>;
  { stage.run(work) }
  noexcept;
  { stage.row_added(clay, RowAdded{}) }
  noexcept;
  { stage.row_divided(clay, RowDivided{}) }
  noexcept;
  { stage.rows_joined(clay, RowsJoined{}) }
  noexcept;
  { stage.forget(clay, Laid{}) }
  noexcept;  ///< The clay was laid anew.
  as_it_is.add_to(hash, clay);
};
// Optional members, called if a stage has them:
//  static void lay_row(const Effects&, Clay&, int j)       lays row j of a fresh lump
//  bool measure_some(Clay&, int element_budget) noexcept   measures a laid clay; true when done
//  bool loaded(int stored) const                           this stored row may not be joined now

/// For a stage that keeps no data of rows between ticks.
struct KeepsNoRows {
  void row_added(const Clay&, const RowAdded&) noexcept {}
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
