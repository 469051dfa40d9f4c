#pragma once

#include <cstdint>

#include "engine/clay/history.h"
#include "engine/scene/hands.h"
#include "engine/scene/row_effects.h"
#include "engine/scene/scene_def.h"

namespace onggi::scene {

/// State of stage 4's work on the lump; drawing in engine/docs/pipeline.md. The numbers are part of
/// state hashes.
enum class LumpState : std::uint8_t {
  playing,    ///< No work: the hands shape the clay.
  keeping,    ///< The old pot is saved to the last bit.
  renewing,   ///< A fresh lump is laid.
  laying,     ///< The effects take over the lump.
  restoring,  ///< The last step is undone.
  settling,   ///< The effects take over the restored clay.
};
inline constexpr int kLumpStates = 6;

enum class LumpEvent : std::uint8_t {
  renew,    ///< Hands::renew became true.
  restore,  ///< Hands::restore became true, and a step can be undone.
  done,     ///< The state's work is done.
};

/// The state after `event` in a scene with every part. A state whose part the scene lacks is
/// skipped.
LumpState after(LumpState state, LumpEvent event) noexcept;

/// Lays a fresh lump, or undoes the last step, a few rows a tick. No allocation; one thread.
class LumpWork {
 public:
  /// The parts it works with; null if the scene lacks one.
  struct Parts {
    const SceneDef& def;
    Clay& clay;
    clay::History* history;
    RowEffects* row_effects;
    effects::Moisture* moisture;
  };

  /// Stage 4. True during work on the lump; all hands then count as away.
  bool step(const Hands& hands, const Parts& parts) noexcept;
  /// Stage 4, at the tick's end: the history records what changed. `touching`: a hand presses clay.
  void follow(const Parts& parts, bool touching, double seconds) noexcept;

  bool playing() const { return state_ == LumpState::playing; }
  /// Five bits for the state's hash.
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
  std::uint64_t step_ = 0;  ///< The last noted depth of the history.
};

}  // namespace onggi::scene
