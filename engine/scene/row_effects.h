#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "engine/clay/history.h"
#include "engine/effects/propagation.h"
#include "engine/effects/refinement.h"
#include "engine/effects/slump.h"
#include "engine/effects/smoothing.h"
#include "engine/effects/springback.h"
#include "engine/effects/tearing.h"
#include "engine/effects/volume.h"
#include "engine/effects/wobble.h"
#include "engine/scene/hands.h"
#include "engine/scene/scene_def.h"

namespace onggi::scene {

/// The effects that ask contact what it did to the clay's rows, and those of stage 6, which work on
/// the rows after it. A scene without any has none of this.
class RowEffects {
 public:
  /// A hand as contact left it.
  struct HandThere {
    Vec3 at;               ///< Clay frame, in the middle of the tick, m.
    double normal = 0.0;   ///< N; 0 where it presses nothing.
    bool on_wall = false;  ///< Not clear, nor on the rim or the floor.
    WallSide side = WallSide::outside;
    double along = 0.0;    ///< As along() said.
    double smooths = 0.0;  ///< How far up and down it evens the wall, m; 0 where it does not.
  };
  /// What a tick brings them.
  struct Tick {
    effects::Moisture* moisture = nullptr;  ///< Null where it is absent.
    clay::History* history = nullptr;       ///< Likewise.
    double wheel_speed = 0.0;               ///< Of the clay, rad/s.
    double seconds = 0.0;
    bool touched = false;    ///< A hand pressed clay.
    std::uint64_t step = 0;  ///< clay::History::depth(); 0 where nothing can be taken back.
    std::array<HandThere, kMaxHands> hand{};
  };

  /// Rows that the clay needs beside the lump's.
  static int spare_rows(const SceneDef& def);
  /// Null where `def` has none. Lays the lump as they have it. Allocates.
  static std::unique_ptr<RowEffects> make(const SceneDef& def, Clay& clay);

  /// Stage 5: share of a press at `pressing` with which the wall gives way as a whole
  /// (Yielding::along). `holding` is the hand on the other face, null where none is.
  double along(const SceneDef& def, Vec3 pressing, const Vec3* holding) const noexcept;
  /// Hand `n` touches clay, or did a moment ago: between two elements of a turning wall it still
  /// holds that wall.
  bool holds(std::size_t n) const { return since_touch_[n] <= kMoment; }
  /// Stage 6: those that are present, in order. No allocation.
  void run(const SceneDef& def, Clay& clay, const Tick& tick) noexcept;
  /// The clay was laid anew, as a `fresh` lump or as it once was: takes it as it is,
  /// `element_budget` elements a call; true when done. `step`: clay::History::depth(), of the step
  /// in which it was laid, or that was taken back with all after it.
  bool settle_some(const SceneDef& def, Clay& clay, bool fresh, std::uint64_t step,
                   int element_budget) noexcept;

  /// Step `step` (clay::History::depth()) begins, with the clay as it is. O(rows).
  void note_step(const Clay& clay, std::uint64_t step) noexcept {
    if (volume_) volume_->note_step(clay, step);
  }

  /// How fast the rim sinks by itself, m/s.
  double sinking() const { return slump_ ? slump_->speed() : 0.0; }
  /// The pot fell, since the clay was last laid.
  bool fallen() const { return slump_ && slump_->fallen(); }
  /// It stands, or sags so little that nobody would call it the beginning of a fall.
  bool stands() const { return !slump_ || slump_->stands(); }
  /// Some row is torn (RowAreas::torn).
  bool torn() const { return tearing_ && tearing_->any(); }
  /// And the last that tore did so before `step`.
  bool torn_before(std::uint64_t step) const { return tearing_ && tearing_->torn_before(step); }
  /// The clay still moves though no hand touches it.
  bool moving() const { return sinking() > 0.0 || (springback_ && !springback_->asleep()); }
  void add_to(StateHash& hash, Clay& clay) const;

 private:
  /// What a tick's work about the contact is for: one face, and the time since it had its turn.
  struct Turn {
    WallSide side = WallSide::outside;
    double seconds = 0.0;
  };
  static constexpr double kMoment = 0.02;  // s: at 1 turn a second, 50 elements to the turn
  using Stage = void (RowEffects::*)(const SceneDef&, Clay&, const Tick&) noexcept;
  void take_turn(Clay& clay, double seconds) noexcept;
  void drag_neighbours(const SceneDef& def, Clay& clay, const Tick& tick) noexcept;
  void spring_back(const SceneDef& def, Clay& clay, const Tick& tick) noexcept;
  void smooth(const SceneDef& def, Clay& clay, const Tick& tick) noexcept;
  void centre(const SceneDef& def, Clay& clay, const Tick& tick) noexcept;
  void sink(const SceneDef& def, Clay& clay, const Tick& tick) noexcept;
  void tear(const SceneDef& def, Clay& clay, const Tick& tick) noexcept;
  void keep_volume(const SceneDef& def, Clay& clay, const Tick& tick) noexcept;
  void refine(const SceneDef& def, Clay& clay, const Tick& tick) noexcept;
  void divide(Clay& clay, int j, const Tick& tick) noexcept;
  void join(Clay& clay, int j, const Tick& tick) noexcept;
  void clear_shifts(const SceneDef& def, Clay& clay, const Tick& tick) noexcept;

  std::optional<effects::Propagation> propagation_;
  std::optional<effects::Springback> springback_;
  std::optional<effects::Smoothing> smoothing_;
  std::optional<effects::Wobble> wobble_;
  std::optional<effects::Slump> slump_;
  std::optional<effects::Tearing> tearing_;
  std::optional<effects::Volume> volume_;
  effects::Refinement refinement_;
  std::vector<Stage> stages_;  // of what is present, in the pipeline's order
  Turn turn_;
  std::array<double, kMaxHands> since_touch_{1.0, 1.0};  // s, at most 1
  bool settled_ = false;                                 // a lump was put on since the last tick
  int laid_to_ = 0;                                      // of settle_some()
};

}  // namespace onggi::scene
