#include "kiosk/ground/files/durable_steps.h"

namespace onggi::files {
namespace {
StepWatcher step_watcher = nullptr;
}  // namespace

void watch_steps(StepWatcher watcher) { step_watcher = watcher; }

void step_done(std::string_view step) {
  if (step_watcher != nullptr) step_watcher(step);
}

}  // namespace onggi::files
