#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "kiosk/picture/render/renderer.h"

namespace onggi::measure {

struct SoakPlan {
  std::filesystem::path config, keepsakes;
  render::WindowOptions window;
  std::string script = "follow";  ///< What the hands do.
  bool by_device = false;         ///< A device alone moves the hand, half a minute a visit.
  double pace = 3;                ///< Of the hands, 0.25..4.
  double minutes = 10;            ///< 0.1..1e5
};

/// Opens the exhibit, with the 1 kHz loop, and lets scripted visitors come and go. Tells every half
/// minute on standard error, and in the end on standard output, what became of memory and ticks. 0,
/// or 1 where a tick was lost. Problem (exit 1) where memory goes on growing or no visit came to
/// its end. Main thread; blocks.
Result<int> soak(const SoakPlan& plan);

}  // namespace onggi::measure
