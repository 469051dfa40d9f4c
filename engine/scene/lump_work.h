#pragma once

#include <cstdint>

#include "engine/clay/history.h"
#include "engine/scene/hands.h"
#include "engine/scene/row_effects.h"
#include "engine/scene/scene_def.h"

namespace onggi::scene {

/// What stage 4 does to the lump. engine/docs/pipeline.md has the drawing. The numbers are in
/// state hashes.
enum class LumpState : std::uint8_t {
  playing,    ///< Nothing: the hands work the clay.
  keeping,    ///< What the pot was is kept to the last bit.
  renewing,   ///< A fresh lump is laid.
  laying,     ///< The effects take it as theirs.
  restoring,  ///< The last step is taken back.
  settling,   ///< The effects take the clay as it is now.
};
inline constexpr int kLumpStates = 6;

enum class LumpEvent : std::uint8_t {
  renew,    ///< Hands::renew became true.
  restore,  ///< Hands::restore did, and there is something to take back.
  done,     ///< The state's work is done.
};

/// The state that comes of `event` in a scene with every part; a state whose part the scene has not
/// is passed over, as if it were done.
LumpState after(LumpState state, LumpEvent event) noexcept;

/// A fresh lump, or the last step taken back, a few rows a tick. No allocation; one thread.
class LumpWork {
 public:
  /// What it works with; null where the scene has none.
  struct Parts {
    const SceneDef& def;
    Clay& clay;
    clay::History* history;
    RowEffects* row_effects;
    effects::Moisture* moisture;
  };

  /// Stage 4. True while the lump is worked on, and nobody else may: all hands are away.
  bool step(const Hands& hands, const Parts& parts) noexcept;
  /// Stage 4, at the tick's end: the history follows what changed. `touching`: a hand presses clay.
  void follow(const Parts& parts, bool touching, double seconds) noexcept;

  bool playing() const { return state_ == LumpState::playing; }
  /// For the state's hash: five bits.
  std::uint64_t bits() const {
    return std::uint64_t{renew_held_} | std::uint64_t{restore_held_} << 1 |
           static_cast<std::uint64_t>(state_) << 2;
  }
  /// The history's depth when the pot last stood.
  std::uint64_t stood_at() const { return stood_at_; }

 private:
  struct Row;
  static const Row& row_of(LumpState state) noexcept;
  friend LumpState after(LumpState state, LumpEvent event) noexcept;

  bool keep(const Parts& parts) const noexcept;
  bool renew(const Parts& parts) const noexcept;
  bool lay(const Parts& parts) const noexcept;
  bool restore(const Parts& parts) const noexcept;
  bool settle(const Parts& parts) const noexcept;
  void go(LumpEvent event, const Parts& parts) noexcept;
  void note_step(const Parts& parts) noexcept;

  LumpState state_ = LumpState::playing;
  bool renew_held_ = false, restore_held_ = false;
  std::uint64_t stood_at_ = 0;
  std::uint64_t step_ = 0;  ///< The history's depth, as it was last noted.
};

}  // namespace onggi::scene
