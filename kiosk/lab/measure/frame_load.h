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

/// What a frame of one screen at one size asks of the graphics when it is drawn as a GPU draws it:
/// the whole window at full scale, four samples a pixel. Counts, and no times: the same on every
/// machine but for shader runs, which are the driver's.
struct FrameLoad {
  int width = 0, height = 0;
  std::string screen;        ///< "attract", "throwing".
  bool moving = true;        ///< false: the wheel stands, and nothing happens.
  int frames = 0;            ///< Counted.
  render::FrameWork work{};  ///< In all of them.
  bool shading_counted = false;
  double a_frame(std::uint64_t count) const {
    return frames > 0 ? static_cast<double>(count) / frames : 0.0;
  }
};

struct FrameLoadPlan {
  std::filesystem::path config;     ///< exhibit.toml
  std::pair<int, int> size;         ///< Pixels.
  int frames = 30;                  ///< Counted of each row, 16 ms of visit apart.
  double attract = 20, naive = 20;  ///< s of throwing that go before.
};

/// Opens the exhibit at `plan.size` on a wheel that is turned by hand, lets attract throw, then a
/// naive visitor (seed 1, mouse), and counts. A display must be there. Keeps nothing. Main thread;
/// a frame takes a machine without a GPU a quarter of a second.
Result<std::vector<FrameLoad>> measure_load(const FrameLoadPlan& plan);

files::Json json_of(const FrameLoad& load);
/// With a head line.
std::string text_of(const std::vector<FrameLoad>& loads);

}  // namespace onggi::measure
