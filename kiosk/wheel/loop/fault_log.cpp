#include "kiosk/wheel/loop/fault_log.h"

#include <utility>

namespace onggi::loop {

std::vector<std::string> FaultLog::news(const LoopStatus& status) {
  if (std::exchange(scene_serial_, status.scene_serial) != status.scene_serial) told_ = 0;
  const std::uint32_t fresh = status.feedback.faults & ~told_;
  told_ |= fresh;
  std::vector<std::string> lines;
  if ((fresh & kFaultInput) != 0)
    lines.emplace_back(
        "A hand's device gave a place that cannot be, or a tool that the scene does not have; the "
        "hand was held where it was. If this returns, look after the device and its cable.");
  if ((fresh & kFaultTime) != 0)
    lines.emplace_back(
        "A tick was to last longer than 5 ms, or no time at all; it was cut to what the clay "
        "bears. If this returns, look for what keeps the processor busy.");
  if ((fresh & kFaultForce) != 0)
    lines.emplace_back(
        "A force came out as no number; the hand felt none instead. If this returns, try the scene "
        "with fewer effects, and report it with the visit's replay.");
  return lines;
}

}  // namespace onggi::loop
