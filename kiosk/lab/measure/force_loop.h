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

/// One device of the list: its limits, and every wall in every hand.
struct DeviceLoops {
  lab::DeviceModel device;
  lab::StiffnessLimit limit;
  std::vector<lab::LoopRow> rows;
};

/// A scene of the program on the weakest and on the best device of the list.
struct ScenesLoops {
  std::string scene;
  lab::DeviceModel device;
  std::vector<lab::SceneLoop> loops;
};

/// The results of `onggi lab loop`: the same on every machine.
struct ForceLoopReport {
  std::vector<DeviceLoops> devices;
  std::vector<ScenesLoops> scenes;
  double seconds = 0.0;  ///< Duration.
  /// True if every device in every hand is stable and passive with lab::kLoopMargin, and still at
  /// rest.
  bool good() const;
};

/// Sweeps lab::device_list(); prints progress and remaining time to `progress`, unless null. Takes
/// half a minute or more.
Result<ForceLoopReport> measure_force_loop(std::FILE* progress);

files::Json json_of(const ForceLoopReport& report);
/// A table and sentences.
std::string text_of(const ForceLoopReport& report);
drawing::Plot plot_of(const ForceLoopReport& report);

/// Derives the stiffness limit of the device in `file` (config/devices/KIND.toml) from its [body],
/// and writes it into its [force] with a comment. Every other byte stays. Problem if the file is
/// not a force device's, or nothing can be derived.
Result<lab::StiffnessLimit> write_stiffness_limit(const std::filesystem::path& file);

}  // namespace onggi::measure
