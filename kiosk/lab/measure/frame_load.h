#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/picture/render/frame_work.h"

namespace onggi::measure {

/// The graphics work of a frame of one screen at one size in the full quality of a GPU: the whole
/// window at full scale, four samples a pixel. Counts without times: the same on every machine
/// except for shader runs, which the driver counts.
struct FrameLoad {
  int width = 0, height = 0;
  std::string screen;        ///< "attract", "throwing".
  bool moving = true;        ///< False: the wheel stands still, and nothing happens.
  int frames = 0;            ///< Number of counted frames.
  render::FrameWork work{};  ///< In all of them.
  bool shading_counted = false;
  double a_frame(std::uint64_t count) const {
    return frames > 0 ? static_cast<double>(count) / frames : 0.0;
  }
};

struct FrameLoadPlan {
  std::filesystem::path config;     ///< exhibit.toml
  std::pair<int, int> size;         ///< Pixels.
  int frames = 30;                  ///< Counted for each row, 16 ms of visit apart.
  double attract = 20, naive = 20;  ///< s of throwing before the count.
};

/// Opens the exhibit at `plan.size` on a stepped wheel, lets attract throw, then a naive visitor
/// (seed 1, mouse), and counts. Needs a display. Keeps nothing. Main thread; without a GPU a frame
/// takes a quarter of a second.
Result<std::vector<FrameLoad>> measure_load(const FrameLoadPlan& plan);

files::Json json_of(const FrameLoad& load);
/// With a header line.
std::string text_of(const std::vector<FrameLoad>& loads);

}  // namespace onggi::measure
