#include "kiosk/visit/screens/fault_note.h"

#include "engine/scene/hands.h"

namespace onggi::screens {

namespace {
constexpr double kTold = 6.0;  // s: time to look up and read a sentence

struct Words {
  std::uint32_t bit;
  const char* key;
};
// Faults in the force come first, because they are felt; then the hand's motion, then the wheel.
constexpr Words kWords[] = {{kFaultForce, "throw.fault_force"},
                            {kFaultInput, "throw.fault_hand"},
                            {kFaultTime, "throw.fault_time"}};
}  // namespace

void FaultNote::update(const loop::LoopStatus& status, double now,
                       loop::WheelCommands& wheel_commands) {
  if (!key_.empty() && now - told_at_ > kTold) key_.clear();
  const std::uint32_t faults = status.feedback.faults;
  if (faults == 0) return;
  for (const Words& words : kWords) {
    if ((faults & words.bit) == 0) continue;
    key_ = words.key;
    told_at_ = now;
    break;
  }
  wheel_commands.clear_faults(faults);
}

std::vector<std::string> FaultNote::keys() {
  std::vector<std::string> all;
  for (const Words& words : kWords) all.emplace_back(words.key);
  return all;
}

}  // namespace onggi::screens
