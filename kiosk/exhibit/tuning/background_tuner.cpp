#include "kiosk/exhibit/tuning/background_tuner.h"

#include <pthread.h>
#include <sys/resource.h>

#include <utility>

namespace onggi::tuning {

BackgroundTuner::BackgroundTuner(std::string name, SceneDef def, TunePlan plan) {
  plan.give_up = [this] { return stop_.load(); };
  thread_ =
      std::thread([this, name = std::move(name), def = std::move(def), plan = std::move(plan)] {
        pthread_setname_np(pthread_self(), "onggi-tune");  // for top -H, and for a test
        // On Linux this affects only this thread.
        setpriority(PRIO_PROCESS, 0, 19);
        found_ = tune(name, def, plan);
        done_ = true;
      });
}

BackgroundTuner::~BackgroundTuner() {
  stop_ = true;
  thread_.join();
}

std::optional<Result<TunedGrid>> BackgroundTuner::take() {
  if (!done_) return std::nullopt;
  return std::exchange(found_, std::nullopt);
}

}  // namespace onggi::tuning
