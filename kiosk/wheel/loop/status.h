#pragma once

#include <array>
#include <cstdint>

#include "engine/force/leather_hand.h"
#include "engine/scene/hand_view.h"
#include "engine/scene/hands.h"

namespace onggi::loop {

/// The timing of the 1 kHz loop since it began.
struct Deadlines {
  std::uint64_t wakes = 0;
  std::uint64_t late = 0;      ///< Woke over 0.5 ms late.
  std::uint64_t overruns = 0;  ///< Missed one whole tick or more.
  std::uint64_t lost_ticks =
      0;  ///< Dropped time, in ticks (the machine stopped for over a quarter second).
  double worst_wake_us = 0;
  double worst_tick_us = 0;
};

/// The loop's state for the main thread at any moment. It is always copied as a whole.
struct LoopStatus {
  std::uint64_t ticks = 0;
  std::int64_t at_ns = 0;  ///< Time of writing, CLOCK_MONOTONIC; 0 if nobody reads it.
  double time = 0;         ///< Simulated s of this scene.
  Hands hands;             ///< As given to the last tick; while paused, as the devices have them.
  std::array<HandView, kMaxHands> hand{};  ///< At the pot, after the tick.
  Feedback feedback;
  bool leather = false;  ///< The clay is leather-hard: it is decorated, and not stepped.
  std::array<force::LeatherPlace, kMaxHands> at_leather{};  ///< Its hands' tools.
  bool scripted = false;                                    ///< A script moves the hands.
  bool shown = false;          ///< No visitor works on the pot: it is shown, or a script's.
  bool hands_taken = false;    ///< A visitor holds a device, whatever moves the hands.
  double script_progress = 0;  ///< 0..1
  bool script_done = false;
  bool can_restore = false;        ///< A renew can be undone.
  std::uint32_t scene_serial = 0;  ///< Number of scenes put on the wheel.
  Deadlines deadlines;
};

}  // namespace onggi::loop
