#include "kiosk/loop/potter_host.h"

#include <chrono>
#include <thread>
#include <utility>

namespace onggi::loop {

PotterHost::~PotterHost() = default;

bool PotterHost::send(const Command& command) {
  if (core_.send(command)) return true;
  // A full queue means that the loop has stood still for 256 wishes. Where the hand is to go is
  // then dropped (the next frame knows better); everything else waits for room, a second at the
  // most.
  if (command.kind == Command::Kind::hand) return false;
  for (int i = 0; i < static_cast<int>(patience_ * 1000); ++i) {
    let_loop_turn();
    if (core_.send(command)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  delete command.pot;
  delete command.script;
  return false;
}

void PotterHost::start(std::unique_ptr<Scene> scene) {
  recording_.reset();
  dropped_ = 0;
  const ClayDef clay = scene->def().clay;
  auto pot = std::make_unique<Pot>(std::move(*scene), ++serial_);
  mirror_.reset(clay.rows, clay.sectors, clay.height, clay.floor_thickness, clay.outer_radius,
                clay.inner_radius);
  current_ = pot.get();
  lent_.reset();
  Command command;
  command.kind = Command::Kind::put;
  command.pot = pot.release();
  if (!send(command)) current_ = nullptr;
}

void PotterHost::play(std::unique_ptr<Script> script) {
  Command command;
  command.kind = Command::Kind::play;
  command.script = script.release();
  send(command);
}

void PotterHost::hand(int index, const HandInput& target) {
  Command command;
  command.kind = Command::Kind::hand;
  command.index = index;
  command.target = target;
  send(command);
}

void PotterHost::wheel(double rad_per_s) {
  Command command;
  command.kind = Command::Kind::wheel;
  command.value = rad_per_s;
  send(command);
}

namespace {
Command wish(Command::Kind kind, bool on = true) {
  Command command;
  command.kind = kind;
  command.on = on;
  return command;
}
}  // namespace

void PotterHost::water(bool held) { send(wish(Command::Kind::water, held)); }
void PotterHost::renew() { send(wish(Command::Kind::renew)); }
void PotterHost::restore() { send(wish(Command::Kind::restore)); }
void PotterHost::pause(bool on) { send(wish(Command::Kind::pause, on)); }

void PotterHost::take_returned() {
  Returned returned;
  while (core_.take_returned(returned)) {
    delete returned.script;
    if (returned.pot == nullptr) continue;
    std::unique_ptr<Pot> pot(returned.pot);
    if (pot.get() == current_) lent_ = std::move(pot);
  }
}

bool PotterHost::put_back() {
  Command back;
  back.kind = Command::Kind::put;
  back.pot = lent_.release();
  if (send(back)) return true;
  current_ = nullptr;
  return false;
}

void PotterHost::note_records(Pot& pot) {
  TickRecord record;
  while (pot.records.try_dequeue(record))
    if (recording_) recording_->tick(record);
}

int PotterHost::collect(const std::function<void(const RowChannel::Row&)>& changed) {
  take_returned();
  if (lent_) put_back();  // It came back after with_scene() had given up waiting.
  if (current_ == nullptr) return 0;
  note_records(*current_);
  if (current_->wet) {
    std::vector<float> wet(WetRows::kHeights);
    for (int i = 0; i < WetRows::kHeights; ++i)
      wet[static_cast<std::size_t>(i)] = current_->wet->at(i);
    mirror_.moisten(std::move(wet));
  }
  int count = 0;
  while (RowChannel::Row* row = current_->rows.take()) {
    mirror_.apply(row->row, row->radii);
    mirror_.stack(row->row, row->middle, row->rim, row->floor);
    mirror_.tear(row->row, row->torn);
    if (changed) changed(*row);
    current_->rows.give_back(row);
    ++count;
  }
  current_->rows.ask();
  return count;
}

void PotterHost::record(const std::string& vessel_id, std::uint64_t seed) {
  if (current_ != nullptr) recording_.emplace(current_->scene.def(), vessel_id, seed);
}

bool PotterHost::with_scene(const std::function<void(Scene&)>& look) {
  if (current_ == nullptr) return false;
  if (!send(wish(Command::Kind::give_back))) return false;
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

std::vector<std::byte> PotterHost::replay(std::uint64_t state_hash,
                                          const std::string& glaze) const {
  if (!recording_) return {};
  ReplayWriter copy = *recording_;
  return copy.finish(state_hash, glaze);
}

}  // namespace onggi::loop
