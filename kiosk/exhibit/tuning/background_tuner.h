#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <thread>

#include "kiosk/exhibit/tuning/tuner.h"

namespace onggi::tuning {

/// Looks for a scene's grid on a thread of its own, with the least claim to the processor, while
/// the exhibit goes on. Main thread.
class BackgroundTuner {
 public:
  BackgroundTuner(std::string name, SceneDef def, TunePlan plan = {});
  /// Gives up, and waits for the measurement that it is at: a second or so.
  ~BackgroundTuner();
  BackgroundTuner(const BackgroundTuner&) = delete;
  BackgroundTuner& operator=(const BackgroundTuner&) = delete;

  /// What was found, once; none while it is still looking. Never waits.
  std::optional<Result<TunedGrid>> take();

 private:
  std::atomic<bool> stop_{false}, done_{false};
  std::optional<Result<TunedGrid>> found_;  // the thread's until done_
  std::thread thread_;
};

}  // namespace onggi::tuning
