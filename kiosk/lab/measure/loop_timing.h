#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/picture/drawing/plot.h"
#include "kiosk/wheel/loop/tick_timing.h"

namespace onggi::measure {

/// The 1 kHz loop for some time, alone or beside other work.
struct TimingPhase {
  std::string name;  ///< "idle", "drawing"
  loop::LoopTiming timing;
  loop::Histogram shown_us;  ///< Age of the shown state when a frame reached the screen.
  loop::Histogram frame_us;  ///< Duration of a frame, from reading the wheel to the screen.
  std::uint64_t older = 0;   ///< Frames that showed a state older than a tick and a frame.
  double seconds = 0.0;
  std::uint64_t misses = 0;  ///< Wakes that missed a whole tick.
};

struct TimingReport {
  std::vector<TimingPhase> phases;
  std::vector<std::string> lacks;  ///< Missing permissions, with remedies.
  bool software_drawing = false;
  /// Whether it is fit for force feedback, and why or what to change: the first sentence is the
  /// verdict.
  bool fit = false;
  std::vector<std::string> words;
};

/// Runs the real loop with a script that throws, `seconds` with the main thread asleep and
/// `seconds` in the open exhibit while it draws. Main thread; blocks. Opens a virtual display if
/// there is none.
Result<TimingReport> measure_loop(const std::filesystem::path& config, double seconds);

files::Json json_of(const TimingReport& report);
std::string text_of(const TimingReport& report);
drawing::Plot plot_of(const TimingReport& report);

}  // namespace onggi::measure
