#pragma once

#include <array>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/effects/effect_list.h"
#include "engine/effects/refinement.h"
#include "engine/scene/hands.h"
#include "engine/scene/scene_def.h"

namespace onggi::scene {

/// The effects on rows: those that read what contact did, and those of stage 6. A scene without
/// them has no RowEffects. effects::RowStages lists the stages; effects::Stage says what each must
/// provide.
class RowEffects {
 public:
  using HandThere = effects::HandThere;
  using Tick = effects::RowTick;

  static int spare_rows(const SceneDef& def);
  /// Null if `def` has no such effect. Lays the lump for its effects. Allocates.
  static std::unique_ptr<RowEffects> make(const Effects& def, Clay& clay);

  /// Stage 5: share of a press at `pressing` by which the wall moves as a whole (Yielding::along).
  /// `holding`: the hand on the other face; null if there is none.
  double along(const Effects& def, Vec3 pressing, const Vec3* holding) const noexcept;
  /// True if hand `n` touches clay or did a moment ago. On a turning wheel contact may pause
  /// between two elements, and the hand still holds the wall.
  bool holds(std::size_t n) const { return since_touch_[n] <= kMoment; }
  /// Stage 5: a hand's coil (clay frame, m) goes from `from` to `to`: Building::lay().
  bool lay(const Effects& def, Clay& clay, Vec3 from, Vec3 to, double seconds,
           std::uint64_t step) noexcept;
  /// Null if absent.
  effects::Building* building();
  /// What hand `n` struck in the last tick; nothing without beating.
  effects::Struck struck(std::size_t n) const {
    const auto& beating = stage<effects::Beating>();
    return beating ? beating->struck(n) : effects::Struck{};
  }
  /// What blows and hands left on the wall: Prints::seen(). Allocates.
  std::vector<Print> prints(const Clay& clay) const;
  /// Stage 6: the present stages, in order. No allocation.
  void run(const Effects& def, Clay& clay, const Tick& tick) noexcept;
  /// Takes over a clay that was laid anew, `element_budget` elements a call. True when done.
  bool settle_some(const Effects& def, Clay& clay, const effects::Laid& laid,
                   int element_budget) noexcept;

  /// Step `step` (clay::History::depth()) begins. O(rows).
  void note_step(const Clay& clay, std::uint64_t step) noexcept;

  /// Speed at which the rim sinks by itself, m/s.
  double sinking() const { return slump() ? slump()->speed() : 0.0; }
  /// The pot fell since the clay was last laid.
  bool fallen() const { return slump() && slump()->fallen(); }
  /// The pot stands, or sags too little for the beginning of a fall.
  bool stands() const { return !slump() || slump()->stands(); }
  /// Some row is torn (RowAreas::torn).
  bool torn() const { return tearing() && tearing()->any(); }
  /// A row is torn, and the last one tore before `step`.
  bool torn_before(std::uint64_t step) const { return tearing() && tearing()->torn_before(step); }
  /// A closed ring of coil is becoming rows.
  bool rises() const { return stage<effects::Building>() && stage<effects::Building>()->rises(); }
  /// The clay moves without a hand.
  bool moving() const { return sinking() > 0.0 || (springback() && !springback()->asleep()); }
  void add_to(StateHash& hash, Clay& clay) const;

 private:
  /// One face, and the time since its last turn, for the work of a tick.
  struct Turn {
    WallSide side = WallSide::outside;
    double seconds = 0.0;
  };
  template <class... S>
  using Present = std::tuple<std::optional<S>...>;
  static constexpr double kMoment = 0.02;  // s: at 1 turn a second with 50 elements a turn

  template <class S>
  const std::optional<S>& stage() const {
    return std::get<std::optional<S>>(stages_);
  }
  const std::optional<effects::Slump>& slump() const { return stage<effects::Slump>(); }
  const std::optional<effects::Tearing>& tearing() const { return stage<effects::Tearing>(); }
  const std::optional<effects::Springback>& springback() const {
    return stage<effects::Springback>();
  }
  effects::Volume* volume();
  effects::Prints* prints();
  template <class Visit>
  void each(Visit&& visit);
  void take_turn(Clay& clay, double seconds) noexcept;
  void add_coil(const Effects& def, Clay& clay, const Tick& tick) noexcept;
  void refine(Clay& clay, const Tick& tick) noexcept;
  void divide(Clay& clay, int j, const Tick& tick) noexcept;
  void join(Clay& clay, int j, const Tick& tick) noexcept;

  effects::RowStages::in<Present> stages_;
  effects::Refinement refinement_;
  Turn turn_;
  std::array<double, kMaxHands> since_touch_{1.0, 1.0};  // s, at most 1
  bool settled_ = false;                                 // a lump was laid since the last tick
  int laid_to_ = 0;                                      // progress of settle_some()
};

}  // namespace onggi::scene
