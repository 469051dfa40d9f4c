#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/replay.h"
#include "kiosk/loop/mirror.h"
#include "kiosk/loop/potter.h"
#include "kiosk/loop/potter_core.h"

namespace onggi::loop {

/// The main thread's end of the wheel: sends commands, keeps the mirror of the clay and the replay
/// of the visit. How ticks come about is the derived class's: a 1 kHz thread, or stepping by hand.
class PotterHost : public PotterCommands {
 public:
  ~PotterHost() override;

  void start(std::unique_ptr<Scene> scene) override;
  void play(std::unique_ptr<Script> script) override;
  void hand(int index, const HandInput& target) override;
  void wheel(double rad_per_s) override;
  void water(bool held) override;
  void renew() override;
  void restore() override;
  void pause(bool on) override;

  /// The newest status; in the same state as the rows of the collect() before, or newer.
  virtual LoopStatus status() const = 0;

  /// Once a frame: takes in what the loop handed back, notes ticks into the replay, applies changed
  /// rows to the mirror and calls `changed(row, radii)` for each. Returns how many rows changed.
  int collect(const std::function<void(const RowChannel::Row&)>& changed);
  const Mirror& mirror() const { return mirror_; }

  /// Notes ticks of the pot on the wheel from its first one. Call right after start().
  void record(const std::string& vessel_id, std::uint64_t seed);
  void stop_recording() { recording_.reset(); }
  /// Ticks that the replay lacks because the main thread stood still for over 16 s. 0 is whole.
  std::uint64_t dropped_records() const { return dropped_; }

  /// Lends the scene to `look` on this thread; the wheel waits meanwhile and then goes on. False
  /// when there is no pot or the loop did not answer within a second.
  bool with_scene(const std::function<void(Scene&)>& look);
  /// The replay so far, ended with the scene's present hash and the glaze that was chosen, if any;
  /// empty when nothing was recorded.
  std::vector<std::byte> replay(std::uint64_t state_hash, const std::string& glaze = {}) const;

 protected:
  /// `patience`: seconds that with_scene() and full queues wait for the loop.
  explicit PotterHost(PotterCore& core, double patience = 1.0) : core_(core), patience_(patience) {}
  /// Lets the loop side take the commands sent (a stepped wheel applies them here; a thread needs
  /// time).
  virtual void let_loop_turn() = 0;

 private:
  bool send(const Command& command);
  void take_returned();
  bool put_back();  ///< Puts lent_ on the wheel again.
  void note_records(Pot& pot);

  PotterCore& core_;
  double patience_;
  Mirror mirror_;
  Pot* current_ = nullptr;     ///< On the wheel, owned by the core.
  std::unique_ptr<Pot> lent_;  ///< Given back by the core for with_scene().
  std::uint32_t serial_ = 0;
  std::optional<ReplayWriter> recording_;
  std::uint64_t dropped_ = 0;
};

}  // namespace onggi::loop
