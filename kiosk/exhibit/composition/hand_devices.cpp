#include "kiosk/exhibit/composition/hand_devices.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace onggi::exhibit {

using view::InputEvent;
using view::Key;

namespace {

constexpr double kBetweenLooks = 1.0;   // s
constexpr double kBetweenBuzzes = 0.4;  // s
constexpr double kNotch = 0.2618;  // rad of a dial for one step of the wheel's speed: 15 degrees

constexpr std::pair<std::uint32_t, Key> kKeys[] = {
    {device::kSide, Key::side},     {device::kWater, Key::water}, {device::kFaster, Key::faster},
    {device::kSlower, Key::slower}, {device::kEnter, Key::enter}, {device::kGoBack, Key::back},
    {device::kLeft, Key::left},     {device::kRight, Key::right}, {device::kUp, Key::up},
    {device::kDown, Key::down}};

constexpr const char* kFaultWords[device::kLinkFaults] = {
    "",
    "was told a force that is not a number",
    "received nothing from the 1 kHz loop for 10 ms",
    "received no update from the screen for 0.5 s",
    "received nothing from the whole program",
    "sent nothing new for 10 ms",
    "sent a broken report",
    "jumped more than 20 mm between reports",
    "did not answer",
    "moved faster than a hand can"};

InputEvent key_event(InputEvent::Kind kind, Key key) {
  InputEvent event;
  event.kind = kind;
  event.key = key;
  return event;
}

/// A hand's device turns with every tick of the wheel; turn one without a hand here.
void turn_through(device::HidLink& link, double seconds) {
  constexpr double kTurn = 1e-3;
  for (; seconds > 0.5 * kTurn; seconds -= kTurn) link.pump(kTurn);
}

std::string newtons(double force) {
  char text[24];
  std::snprintf(text, sizeof text, "%.1f N", force);
  return text;
}

}  // namespace

HandDevices::HandDevices(loop::WheelHost& wheel_host, std::unique_ptr<device::HidBus> bus,
                         device::DeviceWatch::Define define, const Options& options)
    : wheel_host_(wheel_host),
      options_(options),
      watch_(
          std::move(bus),
          options.by_hand ? device::HidLink::Turning::by_hand : device::HidLink::Turning::by_thread,
          std::move(define)) {
  if (options_.by_hand) frame(0.0);
}

HandDevices::~HandDevices() = default;

void HandDevices::take(std::unique_ptr<device::HidLink> link) {
  InUse used;
  used.link = std::move(link);
  const device::KindInfo& info = device::info_of(used.link->kind());
  if (info.hand) {
    for (int hand = 0; hand < kMaxHands && used.index < 0; ++hand)
      if (std::none_of(used_.begin(), used_.end(),
                       [hand](const InUse& other) { return other.index == hand; }))
        used.index = hand;
    if (used.index >= 0) {
      auto hand = std::make_unique<device::HidHand>(used.link, options_.left_handed);
      hand->share(share_ * options_.force);
      used.hand = hand.get();
      if (wheel_host_.attach(std::move(hand), used.index) == nullptr) {
        used.hand = nullptr;
        used.index = -1;
      }
    }
  }
  std::string line = std::string(info.name) + " at " + used.link->listing().path;
  if (!used.link->says().empty()) line += " (" + used.link->says() + ")";
  line += info.hand && used.index < 0 ? " is not used: both hands have a device already."
                                      : " " + std::string(info.use) + ".";
  if (info.force && !used.link->def().stiffness_limit)
    line += " Its stiffness has not been measured yet, so it pushes with at most " +
            newtons(used.link->cap()) + ".";
  if (!info.verified) line += " Its driver has not been tested on real hardware.";
  remarks_.push_back(line);
  news_.device_added(used.link->kind(), info.force);
  used_.push_back(std::move(used));
}

void HandDevices::let_go(InUse& used) {
  remarks_.push_back(std::string(device::info_of(used.link->kind()).name) + " at " +
                     used.link->listing().path + " was unplugged or no longer answers.");
  news_.device_removed(used.link->kind());
  if (used.hand != nullptr) wheel_host_.detach(used.hand);
  watch_.gone(used.link->listing().path);
}

void HandDevices::note_faults(InUse& used, const device::LinkStatus& status) {
  for (std::size_t n = 1; n < status.faults.size(); ++n)
    if (status.faults[n] > 0 && used.faults[n] == 0)
      remarks_.push_back(std::string(device::info_of(used.link->kind()).name) + " " +
                         kFaultWords[n] +
                         "; its force was set to zero at once. If this happens again, check "
                         "the cable, the hub and the processor load.");
  used.faults = status.faults;
}

void HandDevices::add_input(InUse& used, const device::DeviceSample& sample,
                            std::vector<InputEvent>& events) {
  const std::uint32_t changed = sample.buttons ^ std::exchange(used.buttons, sample.buttons);
  for (const auto& [button, key] : kKeys) {
    if ((changed & button) == 0) continue;
    const bool down = (sample.buttons & button) != 0;
    events.push_back(key_event(down ? InputEvent::Kind::key_down : InputEvent::Kind::key_up, key));
  }
  for (; sample.dial - used.dial > kNotch; used.dial += kNotch)
    events.push_back(key_event(InputEvent::Kind::key_down, Key::faster));
  for (; sample.dial - used.dial < -kNotch; used.dial -= kNotch)
    events.push_back(key_event(InputEvent::Kind::key_down, Key::slower));
}

void HandDevices::share(double of_force) {
  share_ = of_force;
  for (const InUse& used : used_)
    if (used.hand != nullptr) used.hand->share(share_ * options_.force);
}

/// Buzzes a dial, which lies under the other hand, when the first hand touches clay.
void HandDevices::buzz_at_a_touch(double now) {
  bool touching = false;
  const loop::LoopStatus& status = wheel_host_.view().status;
  for (const HandFeedback& felt : status.feedback.hand)
    touching = touching || (felt.contact && !status.shown);
  const bool before = std::exchange(touching_, touching);
  const bool begins = touching && !before;
  if (!begins || now - buzzed_at_ < kBetweenBuzzes) return;
  buzzed_at_ = now;
  ++buzzes_;
  for (const InUse& used : used_) {
    if (used.hand != nullptr) continue;
    device::ForceRequest wish;
    wish.buzzes = buzzes_;
    used.link->wish(wish);
  }
}

std::vector<InputEvent> HandDevices::frame(double now) {
  if (options_.by_hand && (looked_at_ < 0.0 || now - looked_at_ >= kBetweenLooks)) {
    looked_at_ = now;
    watch_.look();
  }
  for (auto& link : watch_.arrived()) take(std::move(link));
  std::vector<InputEvent> events;
  bool hold = false, pushes = false;
  std::optional<device::DeviceKind> first_hand;
  std::erase_if(used_, [&](InUse& used) {
    used.link->heartbeat();
    if (options_.by_hand && used.hand == nullptr) turn_through(*used.link, now - last_frame_);
    const device::LinkStatus status = used.link->status();
    note_faults(used, status);
    if (status.sample.lost) {
      let_go(used);
      return true;
    }
    add_input(used, status.sample, events);
    if (status.asks_to_be_held) hold = true;
    if (used.hand != nullptr) {
      pushes = pushes || device::info_of(used.link->kind()).force;
      if (used.index == 0 && used.hand->in_use()) first_hand = used.link->kind();
    }
    return false;
  });
  if (std::all_of(used_.begin(), used_.end(),
                  [](const InUse& used) { return used.link->turns() != used.turns; })) {
    for (InUse& used : used_) used.turns = used.link->turns();
    ++moves_;
  }
  buzz_at_a_touch(now);
  last_frame_ = now;
  news_.update(now, hold);
  news_.device_in_use(first_hand, pushes);
  return events;
}

std::vector<std::string> HandDevices::plugged_in() const {
  std::vector<std::string> names;
  for (const InUse& used : used_) names.emplace_back(device::info_of(used.link->kind()).name);
  return names;
}

std::vector<std::string> HandDevices::remarks() { return std::exchange(remarks_, {}); }

}  // namespace onggi::exhibit
