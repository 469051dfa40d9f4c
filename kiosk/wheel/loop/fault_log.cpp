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
        "A hand device reported an impossible position, or a tool that the scene does not have. "
        "The "
        "hand was held where it was. If this happens again, check the device and its cable.");
  if ((fresh & kFaultTime) != 0)
    lines.emplace_back(
        "A tick was longer than 5 ms, or had no length. It was set to the longest step that the "
        "clay "
        "allows. If this happens again, look for what keeps the processor busy.");
  if ((fresh & kFaultForce) != 0)
    lines.emplace_back(
        "A computed force was not a number, so the hand felt no force. If this happens again, try "
        "the scene "
        "with fewer effects, and report it with the visit's replay.");
  return lines;
}

}  // namespace onggi::loop
