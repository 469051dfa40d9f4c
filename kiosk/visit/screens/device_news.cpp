#include "kiosk/visit/screens/device_news.h"

#include <utility>

namespace onggi::screens {

namespace {
constexpr double kNewsTold = 6.0;  // s: time to look up and read a sentence

constexpr const char* kLost = "throw.device_lost";
constexpr const char* kHold = "throw.device_hold";

constexpr std::pair<device::DeviceKind, const char*> kFound[] = {
    {device::DeviceKind::space_mouse, "throw.device_puck"},
    {device::DeviceKind::surface_dial, "throw.device_dial"},
    {device::DeviceKind::dual_sense, "throw.device_sticks"},
    {device::DeviceKind::polhem, "throw.device_force"},
    {device::DeviceKind::onggi_hid, "throw.device_force"}};

constexpr std::pair<device::DeviceKind, const char*> kUsed[] = {
    {device::DeviceKind::space_mouse, "throw.with_puck"},
    {device::DeviceKind::dual_sense, "throw.with_sticks"},
    {device::DeviceKind::polhem, "throw.with_force"},
    {device::DeviceKind::onggi_hid, "throw.with_force"}};
}  // namespace

void DeviceNews::device_added(device::DeviceKind kind, bool force) {
  for (const auto& [known, key] : kFound)
    if (known == kind) next_ = key;
  again_ = again_ || (force && had_force_);
  had_force_ = had_force_ || force;
}

void DeviceNews::device_removed(device::DeviceKind) { next_ = kLost; }

void DeviceNews::update(double now, bool hold) {
  if (!next_.empty()) {
    key_ = std::exchange(next_, {});
    told_at_ = now;
  }
  // A device that came back is announced until somebody holds it. The first time, its own sentence
  // is enough.
  if (hold && again_) {
    key_ = kHold;
    told_at_ = now;
  } else if (key_ == kHold || now - told_at_ > kNewsTold) {
    key_.clear();
  }
  if (!hold && key_.empty()) again_ = false;
}

void DeviceNews::device_in_use(std::optional<device::DeviceKind> first_hand, bool pushes) {
  pushes_ = pushes;
  in_use_.clear();
  hand_.clear();
  if (!first_hand) return;
  hand_ = device::info_of(*first_hand).id;
  for (const auto& [known, key] : kUsed)
    if (known == *first_hand) in_use_ = key;
}

std::vector<std::string> DeviceNews::keys() {
  std::vector<std::string> all{kLost, kHold};
  for (const auto& [kind, key] : kFound) all.emplace_back(key);
  return all;
}

}  // namespace onggi::screens
