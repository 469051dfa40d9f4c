#pragma once

#include <cstdint>
#include <filesystem>

#include "engine/base/result.h"
#include "kiosk/lab/measure/soak_report.h"
#include "kiosk/picture/render/renderer.h"

namespace onggi::measure {

struct SoakDaysPlan {
  std::filesystem::path config;  ///< The museum's exhibit.toml: read, and copied with its site.
  std::filesystem::path folder;  ///< The soak's own: site, keepsakes and store; made.
  render::WindowOptions window;
  double hours = 72;          ///< Of the museum's clock, 0.5 to 10000.
  double visits_an_hour = 6;  ///< 0.5 to 60.
  std::uint64_t seed = 1;
};

/// Days of a museum in an hour: the open exhibit, its window and its 1 kHz loop, with visitors who
/// begin with the mouse or a finger, throw for some seconds, fire, glaze and keep, in one language
/// after the other; every seventh walks away half-way. The time between two visits is skipped:
/// screens and the clock on the wall go on by it, so that dates change and what is old is removed.
/// Within a visit the screens' clock goes six times as fast; the loop keeps its own. What befalls
/// it meanwhile: SoakTroubles. Tells of each hour on standard error. Main thread; blocks. Problem
/// (exit 1) where it cannot be opened, or the window is closed.
Result<SoakReport> soak_days(const SoakDaysPlan& plan);

}  // namespace onggi::measure
