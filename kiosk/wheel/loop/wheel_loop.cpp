#include "kiosk/wheel/loop/wheel_loop.h"

#include <algorithm>
#include <utility>

namespace onggi::loop {

namespace {
constexpr std::size_t kCommandDepth = 256;
constexpr std::size_t kReturnDepth = 512;
constexpr std::size_t kRecordDepth = 16384;
constexpr int kRowsPerTick = 16;
// s that a slowly leaving hand (PointerHand) needs to be off. After a fresh lump or an undo, the
// hand was not at this clay.
constexpr double kOff = 0.4;
constexpr double kCalmDown = 0.05;  // s from full force to none while ticks are late,
constexpr double kCalmUp = 0.5;     // s and back.

bool is_hand(int hand) { return hand >= 0 && hand < kMaxHands; }
}  // namespace

Pot::Pot(Scene made, std::uint32_t number)
    : scene(std::move(made)),
      serial(number),
      rows(scene.clay().room(), scene.clay().sectors()),  // it may grow
      records(kRecordDepth) {
  scene.mark_all_dirty();
  const auto& moisture = scene.def().moisture;
  if (moisture && moisture->sponge_height > 0.0) wet = std::make_unique<WetnessByRow>();
  if (scene.def().building) coil = std::make_unique<CoilByAngle>();
}

WheelLoop::WheelLoop() : commands_(kCommandDepth), returned_(kReturnDepth) {}

WheelLoop::~WheelLoop() {
  Command command;
  while (commands_.try_dequeue(command)) {
    if (const auto* put = std::get_if<command::Put>(&command)) delete put->pot;
    if (const auto* play = std::get_if<command::Play>(&command)) delete play->script;
    if (const auto* harden = std::get_if<command::Harden>(&command)) delete harden->wall;
  }
  Returned returned;
  while (returned_.try_dequeue(returned)) {
    delete returned.pot;
    delete returned.script;
    delete returned.wall;
  }
  delete leather_.begin(nullptr);
  delete pot_;
  delete script_;
}

void WheelLoop::hand_back(const Returned& done) noexcept {
  if (done.pot != nullptr || done.script != nullptr || done.device != nullptr ||
      done.wall != nullptr)
    returned_.try_enqueue(done);
}

void WheelLoop::lift_hands() noexcept {
  led_ = false;
  asked_ = Hands{};
  for (std::size_t n = 0; n < attached_; ++n) devices_[n].device->lead(HandInput{});
}

void WheelLoop::apply(const command::Put& wish) noexcept {
  hand_back({std::exchange(pot_, wish.pot), std::exchange(script_, nullptr), nullptr});
  // A lent pot returns unchanged; a new one finds the hands lifted and empty.
  if (status_.scene_serial == pot_->serial) return;
  end_leather(true);
  lift_hands();
  taken_ = {};
  in_hand_ = InHand::tool;
  swings_ = {};
  status_.scene_serial = pot_->serial;
  paused_ = shown_ = false;
}

void WheelLoop::apply(const command::GiveBack&) noexcept {
  hand_back({std::exchange(pot_, nullptr), std::exchange(script_, nullptr), nullptr});
}

void WheelLoop::apply(const command::Play& wish) noexcept {
  hand_back({nullptr, std::exchange(script_, wish.script), nullptr});
  script_time_ = 0;
  if (script_ != nullptr) end_leather(true);
  lift_hands();
}

void WheelLoop::apply(const command::Attach& wish) noexcept {
  if (attached_ == devices_.size() || !is_hand(wish.hand))
    return hand_back({nullptr, nullptr, wish.device});
  devices_[attached_++] = {wish.device, wish.hand};
}

void WheelLoop::apply(const command::Detach& wish) noexcept {
  const auto end = devices_.begin() + static_cast<std::ptrdiff_t>(attached_);
  const auto found = std::find_if(devices_.begin(), end, [&wish](const Attached& attached) {
    return attached.device == wish.device;
  });
  if (found == end) return;
  found->device->feel({});
  std::replace(leads_.begin(), leads_.end(), wish.device,
               static_cast<device::HandDevice*>(nullptr));
  hand_back({nullptr, nullptr, wish.device});
  std::move(found + 1, end, found);
  --attached_;
}

void WheelLoop::apply(const command::Lead& wish) noexcept {
  if (wish.hand == 0) led_ = wish.target.active;
  for (std::size_t n = 0; n < attached_; ++n)
    if (devices_[n].hand == wish.hand) devices_[n].device->lead(wish.target);
}

void WheelLoop::apply(const command::Take& wish) noexcept {
  if (is_hand(wish.hand)) taken_[static_cast<std::size_t>(wish.hand)] = wish.tool;
}

void WheelLoop::apply(const command::Hold& wish) noexcept {
  // A hand that leaves the rim with its coil must not come back as a fingertip in it.
  if (in_hand_ != wish.what) off_ = kOff;
  in_hand_ = wish.what;
  swings_ = {};
}

void WheelLoop::apply(const command::Pause& wish) noexcept {
  paused_ = wish.on;
  if (!paused_) return;
  // No hand works on a paused pot.
  status_.hand = {};
  status_.feedback.hand = {};
}

void WheelLoop::apply(const command::Harden& wish) noexcept {
  if (wish.wall == nullptr) return leather_.end();
  hand_back({nullptr, nullptr, nullptr, leather_.begin(wish.wall)});
}

void WheelLoop::end_leather(bool now) noexcept {
  hand_back({nullptr, nullptr, nullptr, leather_.ended(now)});
  if (leather_.on()) return;
  status_.leather = false;
  status_.at_leather = {};
}

void WheelLoop::apply(const command::ClearFaults& wish) noexcept {
  if (pot_ == nullptr) return;
  pot_->scene.clear_faults(wish.which);
  status_.feedback.faults &= ~wish.which;
}

void WheelLoop::read_hands(double dt, Hands& hands) noexcept {
  hands.hand = {};
  leads_ = {};
  device_age_ = -1.0;
  status_.hands_taken = false;
  for (std::size_t n = 0; n < attached_; ++n) {
    const Attached& attached = devices_[n];
    const HandInput read = attached.device->read(dt);
    device_age_ = std::max(device_age_, attached.device->age());
    // A hand that the screens lead may work with nobody there.
    const bool visitors = !attached.device->led();
    status_.hands_taken = status_.hands_taken || (read.active && visitors);
    // A visitor's device does not move a pot that is only shown.
    if (shown_ && visitors) continue;
    const auto h = static_cast<std::size_t>(attached.hand);
    // If several devices share a hand, the last one that came and is in use leads.
    if (!read.active && hands.hand[h].active) continue;
    hands.hand[h] = read;
    leads_[h] = attached.device;
  }
  for (std::size_t h = 0; h < taken_.size(); ++h)
    if (taken_[h]) hands.hand[h].tool = *taken_[h];
  hands.hand[0].coil = in_hand_ == InHand::coil;
  off_ = asked_.renew || asked_.restore ? kOff : std::max(0.0, off_ - dt);
  if (off_ > 0)
    for (HandInput& hand : hands.hand) hand.active = false;
  if (in_hand_ == InHand::paddle) beat(dt, hands.hand[0]);
}

void WheelLoop::beat(double dt, HandInput& hand) noexcept {
  const bool led = leads_[0] != nullptr && leads_[0]->led();
  const bool there = led ? led_ : status_.feedback.hand[0].contact;
  hand.tool = 0;
  hand.coil = false;
  hand.paddle = true;
  hand.swing = swings_.paddle;
  hand.anvil = swings_.anvil;
  hand.blow = paddle_.step(hand.active && there, dt);
  // A visitor's own hand swings by itself.
  const double out = axis_distance(hand.position);
  if (!led || !(out > 0.0)) return;
  const double back = Paddle::kSwing * paddle_.back() / out;
  hand.position += back * Vec3{hand.position.x, 0.0, hand.position.z};
}

void WheelLoop::feel(const std::array<HandFeedback, kMaxHands>& felt) noexcept {
  for (std::size_t n = 0; n < attached_; ++n) {
    const auto h = static_cast<std::size_t>(devices_[n].hand);
    HandFeedback mine = leads_[h] == devices_[n].device ? felt[h] : HandFeedback{};
    mine.force = calm_ * mine.force;
    mine.touch.push = calm_ * mine.touch.push;
    mine.touch.stiffness *= calm_;
    mine.touch.grip *= calm_;
    mine.blow *= calm_;
    devices_[n].device->feel(mine);
  }
}

void WheelLoop::take_commands() noexcept {
  Command command;
  // Everything that a command replaces must fit into the return queue, so that nothing is lost or
  // deleted here.
  while (returned_.size_approx() < kReturnDepth && commands_.try_dequeue(command))
    std::visit([this](const auto& wish) { apply(wish); }, command);
}

void WheelLoop::step(double dt) noexcept {
  Hands hands = asked_;
  read_hands(dt, hands);
  if (script_ != nullptr) {
    script_time_ += dt;
    hands = script_->at(script_time_, pot_->scene.clay());
    leads_ = {};  // nobody feels a script's forces
  } else {
    asked_.renew = asked_.restore = false;
  }
  const TickRecord record{hands, dt};
  status_.feedback = pot_->scene.step(record.hands, record.dt);
  status_.hands = record.hands;
  for (int n = 0; n < kMaxHands; ++n)
    status_.hand[static_cast<std::size_t>(n)] = pot_->scene.hand(n);
  if (!pot_->records.try_enqueue(record)) ++pot_->dropped_records;
  feel(status_.feedback.hand);
}

void WheelLoop::decorate(double dt) noexcept {
  read_hands(dt, status_.hands);
  // Hands that the screens lead shape soft clay; on the screen Decorate a finger needs none.
  std::array<HandInput, kMaxHands> hands = status_.hands.hand;
  for (std::size_t h = 0; h < hands.size(); ++h)
    if (leads_[h] == nullptr || leads_[h]->led()) hands[h].active = false;
  const GuardDef guard = pot_ != nullptr ? pot_->scene.def().guard : GuardDef{};
  status_.feedback.hand =
      leather_.step(hands, dt, {guard.max_force, guard.max_slew, guard.engage_time});
  status_.hand = {};
  status_.leather = true;
  for (int h = 0; h < kMaxHands; ++h)
    status_.at_leather[static_cast<std::size_t>(h)] = leather_.place(h);
  feel(status_.feedback.hand);
  end_leather(false);
}

void WheelLoop::tick(double dt) noexcept {
  take_commands();
  calm_ = std::clamp(calm_ + (strained_ ? -dt / kCalmDown : dt / kCalmUp), 0.0, 1.0);
  status_.scripted = script_ != nullptr;
  status_.shown = shown_ || script_ != nullptr;
  if (leather_.on()) {
    decorate(dt);
  } else if (pot_ != nullptr && !paused_) {
    step(dt);
  } else {
    // A moving hand means that a visitor is there, and it must stop feeling clay that it left.
    if (script_ == nullptr) read_hands(dt, status_.hands);
    feel({});
  }
  if (pot_ == nullptr) return;
  pot_->rows.publish(pot_->scene, kRowsPerTick);
  if (pot_->wet) pot_->wet->publish(pot_->scene);
  if (pot_->coil) pot_->coil->publish(pot_->scene.coil());
  status_.ticks = pot_->scene.counters().ticks;
  status_.time = pot_->scene.time();
  status_.can_restore = pot_->scene.can_restore();
  status_.script_progress =
      script_ == nullptr ? 0 : std::min(1.0, script_time_ / std::max(1e-3, script_->duration()));
  status_.script_done = script_ != nullptr && script_time_ >= script_->duration();
}

}  // namespace onggi::loop
