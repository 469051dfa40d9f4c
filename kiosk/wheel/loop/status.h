#pragma once

#include <array>
#include <cstdint>

#include "engine/scene/hand_view.h"
#include "engine/scene/hands.h"

namespace onggi::loop {

/// How well the 1 kHz loop keeps time, since it began.
struct Deadlines {
  std::uint64_t wakes = 0;
  std::uint64_t late = 0;      ///< Woke over 0.5 ms late.
  std::uint64_t overruns = 0;  ///< Missed one whole tick or more.
  std::uint64_t lost_ticks =
      0;  ///< Time given up for good, in ticks (the machine stood still for over a quarter second).
  double worst_wake_us = 0;
  double worst_tick_us = 0;
};

/// What the main thread may know of the loop at any moment. Copied whole, never half old.
struct LoopStatus {
  std::uint64_t ticks = 0;
  std::int64_t at_ns = 0;  ///< When it was written, CLOCK_MONOTONIC; 0 where nobody looks.
  double time = 0;         ///< Simulated s of this scene.
  Hands hands;  ///< As given to the last tick; while the pot rests, as the devices have them.
  std::array<HandView, kMaxHands> hand{};  ///< At the pot, after it.
  Feedback feedback;
  bool scripted = false;       ///< A script moves the hands.
  bool shown = false;          ///< No visitor works on the pot: it is shown, or a script's.
  bool hands_taken = false;    ///< A visitor holds a device of their own, whoever moves the hands.
  double script_progress = 0;  ///< 0..1
  bool script_done = false;
  bool can_restore = false;        ///< A renew may be taken back.
  std::uint32_t scene_serial = 0;  ///< Counts scenes swapped in.
  Deadlines deadlines;
};

}  // namespace onggi::loop
