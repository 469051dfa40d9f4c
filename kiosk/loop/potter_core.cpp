#include "kiosk/loop/potter_core.h"

#include <algorithm>
#include <utility>

namespace onggi::loop {

namespace {
constexpr std::size_t kCommandDepth = 256;
constexpr std::size_t kReturnDepth = 512;
constexpr std::size_t kRecordDepth = 16384;
constexpr int kRowsPerTick = 16;
}  // namespace

Pot::Pot(Scene made, std::uint32_t number)
    : scene(std::move(made)),
      serial(number),
      rows(scene.clay().rows(), scene.clay().sectors()),
      records(kRecordDepth) {
  scene.mark_all_dirty();
  const auto& moisture = scene.def().moisture;
  if (moisture && moisture->sponge_height > 0.0) wet = std::make_unique<WetRows>();
}

PotterCore::PotterCore() : commands_(kCommandDepth), returned_(kReturnDepth) {}

PotterCore::~PotterCore() {
  Command command;
  while (commands_.try_dequeue(command)) {
    delete command.pot;
    delete command.script;
  }
  Returned returned;
  while (returned_.try_dequeue(returned)) {
    delete returned.pot;
    delete returned.script;
  }
  delete pot_;
  delete script_;
}

void PotterCore::hand_back(Pot* pot, Script* script) noexcept {
  if (pot != nullptr || script != nullptr) returned_.try_enqueue(Returned{pot, script});
}

void PotterCore::apply(const Command& command) noexcept {
  using Kind = Command::Kind;
  switch (command.kind) {
    case Kind::put: {
      hand_back(std::exchange(pot_, command.pot), std::exchange(script_, nullptr));
      // A pot that was only lent comes back as it was; a new one finds the hands lifted.
      if (status_.scene_serial != pot_->serial) {
        asked_ = Hands{};
        pointers_ = {};
        status_.scene_serial = pot_->serial;
        paused_ = false;
      }
      break;
    }
    case Kind::give_back:
      hand_back(std::exchange(pot_, nullptr), std::exchange(script_, nullptr));
      break;
    case Kind::play:
      hand_back(nullptr, std::exchange(script_, command.script));
      script_time_ = 0;
      asked_ = Hands{};
      pointers_ = {};
      break;
    case Kind::hand:
      if (command.index >= 0 && command.index < kMaxHands)
        pointers_[static_cast<std::size_t>(command.index)].aim(command.target);
      break;
    case Kind::wheel:
      asked_.wheel_speed = command.value;
      break;
    case Kind::water:
      asked_.water = command.on;
      break;
    case Kind::renew:
      asked_.renew = true;
      break;
    case Kind::restore:
      asked_.restore = true;
      break;
    case Kind::pause:
      paused_ = command.on;
      break;
  }
}

Hands PotterCore::gather(double dt) noexcept {
  if (script_ != nullptr) {
    script_time_ += dt;
    return script_->at(script_time_, pot_->scene.clay());
  }
  Hands hands = asked_;
  for (std::size_t i = 0; i < pointers_.size(); ++i) hands.hand[i] = pointers_[i].read(dt);
  asked_.renew = asked_.restore = false;
  return hands;
}

void PotterCore::take_commands() noexcept {
  Command command;
  // What a command displaces must find room on the way back, so that nothing is ever lost or
  // deleted here.
  while (returned_.size_approx() < kReturnDepth && commands_.try_dequeue(command)) apply(command);
}

void PotterCore::tick(double dt) noexcept {
  take_commands();
  status_.scripted = script_ != nullptr;
  if (pot_ == nullptr) return;
  if (!paused_) {
    const TickRecord record{gather(dt), dt};
    status_.feedback = pot_->scene.step(record.hands, record.dt);
    status_.hands = record.hands;
    if (!pot_->records.try_enqueue(record)) ++pot_->dropped_records;
    for (std::size_t i = 0; i < pointers_.size(); ++i) pointers_[i].feel(status_.feedback.hand[i]);
  }
  pot_->rows.publish(pot_->scene, kRowsPerTick);
  if (pot_->wet) pot_->wet->publish(pot_->scene);
  status_.ticks = pot_->scene.counters().ticks;
  status_.time = pot_->scene.time();
  status_.can_restore = pot_->scene.can_restore();
  status_.script_progress =
      script_ == nullptr ? 0 : std::min(1.0, script_time_ / std::max(1e-3, script_->duration()));
  status_.script_done = script_ != nullptr && script_time_ >= script_->duration();
}

}  // namespace onggi::loop
