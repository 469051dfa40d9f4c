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
  bool by_device = false;         ///< Only a device moves the hand, half a minute a visit.
  double pace = 3;                ///< Of the hands, 0.25..4.
  double minutes = 10;            ///< 0.1..1e5
};

/// Opens the exhibit with the 1 kHz loop and runs scripted visitors one after another. Every half
/// minute it reports memory and ticks on standard error, and at the end on standard output. Returns
/// 0, or 1 if a tick was lost. Problem (exit 1) if memory keeps growing or no visit ended. Main
/// thread; blocks.
Result<int> soak(const SoakPlan& plan);

}  // namespace onggi::measure
