#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <thread>

#include "kiosk/exhibit/tuning/tuner.h"

namespace onggi::tuning {

/// Finds a scene's grid on its own thread with the lowest priority, while the exhibit runs. Main
/// thread.
class BackgroundTuner {
 public:
  BackgroundTuner(std::string name, SceneDef def, TunePlan plan = {});
  /// Stops, and waits for the current measurement: about a second.
  ~BackgroundTuner();
  BackgroundTuner(const BackgroundTuner&) = delete;
  BackgroundTuner& operator=(const BackgroundTuner&) = delete;

  /// The result, once; absent while it is searching. Never waits.
  std::optional<Result<TunedGrid>> take();

 private:
  std::atomic<bool> stop_{false}, done_{false};
  std::optional<Result<TunedGrid>> found_;  // the thread's until done_
  std::thread thread_;
};

}  // namespace onggi::tuning
