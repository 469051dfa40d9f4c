#pragma once

#include <cstdint>
#include <filesystem>

#include "engine/base/result.h"
#include "kiosk/lab/measure/soak_report.h"
#include "kiosk/picture/render/renderer.h"

namespace onggi::measure {

struct SoakDaysPlan {
  std::filesystem::path config;  ///< The museum's exhibit.toml: read, and copied with its site.
  std::filesystem::path folder;  ///< The soak's own folder: site, keepsakes and store; created.
  render::WindowOptions window;
  double hours = 72;          ///< Of the museum's clock, 0.5 to 10000.
  double visits_an_hour = 6;  ///< 0.5 to 60.
  std::uint64_t seed = 1;
};

/// Days of a museum in an hour: the open exhibit, its window and its 1 kHz loop, with visitors who
/// begin with the mouse or a finger, throw for some seconds, fire, glaze and keep, in one language
/// after another; every seventh leaves half-way. The time between two visits is skipped: screens
/// and wall clock jump, so that dates change and old keepsakes are removed. Within a visit the
/// screens' clock runs six times as fast; the loop keeps real time. SoakTroubles happen meanwhile.
/// Reports each hour on standard error. Main thread; blocks. Problem (exit 1) if it cannot be
/// opened, or if the window is closed.
Result<SoakReport> soak_days(const SoakDaysPlan& plan);

}  // namespace onggi::measure
