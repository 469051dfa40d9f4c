#include "kiosk/wheel/loop/wheel_host.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "kiosk/wheel/device/pointer_hand.h"

namespace onggi::loop {

WheelHost::WheelHost(double patience) : patience_(patience) {
  for (int hand = 0; hand < kMaxHands; ++hand)
    attach(std::make_unique<device::PointerHand>(), hand);
}

WheelHost::~WheelHost() = default;

bool WheelHost::send(const Command& command) {
  if (core_.send(command)) return true;
  // A full queue means that the loop has stopped for 256 commands. What the next frame sends anew
  // is then dropped: a hand's target, a tool. Everything else waits for space, at most a second.
  if (std::holds_alternative<command::Lead>(command) ||
      std::holds_alternative<command::Decorate>(command))
    return false;
  for (int i = 0; i < static_cast<int>(patience_ * 1000); ++i) {
    let_loop_turn();
    if (core_.send(command)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (const auto* put = std::get_if<command::Put>(&command)) delete put->pot;
  if (const auto* play = std::get_if<command::Play>(&command)) delete play->script;
  if (const auto* harden = std::get_if<command::Harden>(&command)) delete harden->wall;
  return false;
}

void WheelHost::start(std::unique_ptr<Scene> scene) {
  recording_.reset();
  dropped_ = 0;
  view_.clay.lay(scene->def().clay, scene->clay().room());
  view_.coil = {};
  view_.prints.clear();
  if (scene->def().building) view_.coil.diameter = scene->def().building->coil;
  auto pot = std::make_unique<Pot>(std::move(*scene), ++serial_);
  current_ = pot.get();
  lent_.reset();
  if (!send(command::Put{pot.release()})) current_ = nullptr;
}

void WheelHost::play(std::unique_ptr<Script> script) { send(command::Play{script.release()}); }

void WheelHost::hand(int index, const HandInput& target) { send(command::Lead{index, target}); }

device::HandDevice* WheelHost::attach(std::unique_ptr<device::HandDevice> device, int hand) {
  device::HandDevice* const name = device.get();
  if (!send(command::Attach{name, hand})) return nullptr;
  devices_.push_back(std::move(device));
  return name;
}

void WheelHost::take_returned() {
  Returned returned;
  while (core_.take_returned(returned)) {
    delete returned.script;
    delete returned.wall;
    if (returned.device != nullptr)
      std::erase_if(devices_,
                    [&returned](const auto& mine) { return mine.get() == returned.device; });
    if (returned.pot == nullptr) continue;
    std::unique_ptr<Pot> pot(returned.pot);
    if (pot.get() == current_) lent_ = std::move(pot);
  }
}

bool WheelHost::put_back() {
  if (send(command::Put{lent_.release()})) return true;
  current_ = nullptr;
  return false;
}

void WheelHost::note_records(Pot& pot) {
  TickRecord record;
  while (pot.records.try_dequeue(record)) {
    // Somebody who stays for over an hour gets the pot without its replay, and memory has an end.
    if (recording_ && recording_->full()) recording_.reset();
    if (recording_) recording_->tick(record);
  }
}

int WheelHost::collect() {
  take_returned();
  if (lent_) put_back();  // it came back after with_scene() had stopped waiting
  int count = 0;
  if (current_ != nullptr) {
    note_records(*current_);
    count = current_->rows.take_into(view_.clay);
    current_->rows.ask();
    if (current_->wet) current_->wet->copy_to(view_.clay.wet);
    if (current_->coil) current_->coil->copy_to(view_.coil);
  }
  view_.status = status();
  view_.clay.angle = view_.status.feedback.clay_angle;
  view_.clay.cut_free = view_.status.feedback.cut_free;
  return count;
}

bool WheelHost::refresh_every_row() {
  const bool settled = with_scene([this](Scene& scene) {
    // Queued rows are older than the scene's.
    lent_->rows.take_into(view_.clay);
    take_rest_into(view_.clay, scene);
    view_.prints = scene.prints();
  });
  if (settled) collect();
  return settled;
}

void WheelHost::record(const std::string& vessel_id, std::uint64_t seed) {
  if (current_ != nullptr) recording_.emplace(current_->scene.def(), vessel_id, seed);
}

bool WheelHost::with_scene(const std::function<void(Scene&)>& look) {
  if (current_ == nullptr) return false;
  if (!send(command::GiveBack{})) return false;
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience_);
  for (;;) {
    let_loop_turn();
    take_returned();
    if (lent_) break;
    if (std::chrono::steady_clock::now() > until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  note_records(*lent_);
  dropped_ += std::exchange(lent_->dropped_records, 0);
  look(lent_->scene);
  return put_back();
}

std::vector<std::byte> WheelHost::replay(std::uint64_t state_hash, const std::string& glaze) const {
  return recording_ ? recording_->finish(state_hash, glaze) : std::vector<std::byte>();
}

}  // namespace onggi::loop
