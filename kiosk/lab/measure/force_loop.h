#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/lab/loop_sweep.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/picture/drawing/plot.h"

namespace onggi::measure {

/// One device of the list: what it bears, and every wall in every hand.
struct DeviceLoops {
  lab::DeviceModel device;
  lab::StiffnessLimit limit;
  std::vector<lab::LoopRow> rows;
};

/// A scene of the program's on the least and on the best device of the list.
struct ScenesLoops {
  std::string scene;
  lab::DeviceModel device;
  std::vector<lab::SceneLoop> loops;
};

/// What `onggi lab loop` found: the same on every machine.
struct ForceLoopReport {
  std::vector<DeviceLoops> devices;
  std::vector<ScenesLoops> scenes;
  double seconds = 0.0;  ///< That it took.
  /// What ships is stable and passive with lab::kLoopMargin on every device and in every hand, and
  /// at rest it is still.
  bool good() const;
};

/// Sweeps lab::device_list(); progress and the time that remains go to `progress`, unless null.
/// Half a minute and more.
Result<ForceLoopReport> measure_force_loop(std::FILE* progress);

files::Json json_of(const ForceLoopReport& report);
/// A table, and sentences.
std::string text_of(const ForceLoopReport& report);
drawing::Plot plot_of(const ForceLoopReport& report);

/// Derives the stiffness limit of the device in `file` (config/devices/KIND.toml) from its [body],
/// and writes it into its [force] with a comment that says so. Everything else stays as it is, to
/// the byte. Problem where the file is none of a force device's, or nothing can be derived.
Result<lab::StiffnessLimit> write_stiffness_limit(const std::filesystem::path& file);

}  // namespace onggi::measure
