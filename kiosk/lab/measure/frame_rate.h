#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/lab/measure/decorated_frames.h"
#include "kiosk/lab/measure/frame_load.h"
#include "kiosk/picture/drawing/plot.h"

namespace onggi::measure {

struct FrameRatePlan {
  std::filesystem::path config;
  std::vector<std::pair<int, int>> sizes{{1280, 720}, {1920, 1080}};  ///< Pixels.
  double seconds = 15.0;    ///< For each screen at each size, 2 to 600.
  bool only_loads = false;  ///< No times: only the graphics work of a frame.
};

/// The open exhibit, drawing one screen at one size beside the running 1 kHz loop.
struct FrameRateRow {
  int width = 0, height = 0;
  std::string screen;  ///< "attract", "throwing" (a naive visitor's mouse at work)
  int frames = 0;
  double fps_median = 0, fps_p5 = 0;  ///< Frames per second; one frame in twenty is slower than p5.
  double main_thread_share = 0;       ///< Processor time of the drawing thread over time.
  double render_scale = 0;            ///< Of the 3-D picture, mean.
  /// Similarity of the pot's part of the picture to full quality.
  double ssim = 0, ssim_least = 0;
};

/// Delays, measured once a size.
struct FrameDelays {
  int width = 0, height = 0;
  double first_picture_ms = 0;     ///< From opening the exhibit to its first frame on the screen.
  std::optional<double> still_ms;  ///< From the last motion to a picture at full quality.
  std::optional<int> drag_frames;  ///< From a drag to the first frame that shows the hand moved.
};

struct FrameRateReport {
  std::string device;  ///< The graphics device.
  bool software = false;
  std::vector<FrameRateRow> rows;
  std::vector<FrameDelays> delays;
  std::vector<DecoratedFrames> decorated;
  std::vector<FrameLoad> loads;
};

/// Opens the exhibit in a window of each size (on a virtual display if there is none), lets attract
/// play, throws like a naive visitor, then releases and stops the wheel. Pictures are compared once
/// a second; frames around a comparison are not counted. Then measures decorated pots, and counts
/// the graphics work of a frame. Prints progress to `progress`. Main thread; blocks for about
/// 2 x `seconds` + 120 s a size.
Result<FrameRateReport> measure_frames(const FrameRatePlan& plan, std::FILE* progress);

files::Json json_of(const FrameRateReport& report);
std::string text_of(const FrameRateReport& report);
drawing::Plot plot_of(const FrameRateReport& report);

}  // namespace onggi::measure
