#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/replay.h"
#include "kiosk/wheel/device/hand_device.h"
#include "kiosk/wheel/loop/wheel_commands.h"
#include "kiosk/wheel/loop/wheel_loop.h"
#include "kiosk/wheel/loop/wheel_view.h"

namespace onggi::loop {

/// The main thread's side of the wheel: sends commands, owns the devices, keeps the view of the
/// wheel and the visit's replay. The derived class makes the ticks: a 1 kHz thread, or stepping by
/// hand. A pointer device (mouse, touch, keys) is attached for every hand.
class WheelHost : public WheelCommands {
 public:
  ~WheelHost() override;

  void start(std::unique_ptr<Scene> scene) override;
  void play(std::unique_ptr<Script> script) override;
  void hand(int index, const HandInput& target) override;
  void take(int index, std::uint8_t tool) override { send(command::Take{index, tool}); }
  void hold(InHand what) override { send(command::Hold{what}); }
  void swing(const script::Swings& swings) override { send(command::Swing{swings}); }
  void wheel(double rad_per_s) override { send(command::TurnWheel{rad_per_s}); }
  void water(bool held) override { send(command::Water{held}); }
  void fire(bool hangs) override { send(command::Fire{hangs}); }
  void renew() override { send(command::Renew{}); }
  void restore() override { send(command::Restore{}); }
  void pause(bool on) override { send(command::Pause{on}); }
  void harden(std::unique_ptr<force::LeatherOutline> wall) override {
    send(command::Harden{wall.release()});
  }
  void decorate(const force::DecoratingTool& tool, const force::LeatherTurn& turn) override {
    send(command::Decorate{tool, turn});
  }
  void clear_faults(std::uint32_t which) override { send(command::ClearFaults{which}); }
  bool refresh_every_row() override;
  /// Only shows the wheel until the next pot: visitors' devices neither work on it nor feel it.
  /// Devices that the screens lead do.
  void show() { send(command::Show{}); }

  /// From the next tick on the loop reads `device` for hand `hand`. If several devices share a
  /// hand, the last one that came and is in use leads. At most eight; one too many, or one for a
  /// hand that does not exist, is destroyed. Returns its handle for detach(), valid until then.
  device::HandDevice* attach(std::unique_ptr<device::HandDevice> device, int hand);
  /// The loop releases the device; then it is destroyed.
  void detach(device::HandDevice* device) { send(command::Detach{device}); }

  /// The newest status; view() has the one that matches its clay.
  virtual LoopStatus status() const = 0;

  /// Once a frame: takes what the loop returned, adds ticks to the replay, and updates the view
  /// with the published rows. Returns the number of rows. Rows allocate nothing.
  int collect();
  const WheelView& view() const { return view_; }

  /// Records ticks of the pot on the wheel from its first one. Call right after start().
  void record(const std::string& vessel_id, std::uint64_t seed);
  void stop_recording() { recording_.reset(); }
  /// Ticks missing in the replay because the main thread stopped for over 16 s. 0: complete.
  std::uint64_t dropped_records() const { return dropped_; }

  /// Lends the scene to `look` on this thread; the wheel waits and then continues. False if there
  /// is no pot or the loop did not answer within a second.
  bool with_scene(const std::function<void(Scene&)>& look);
  /// The replay so far, ended with the scene's current hash and the chosen glaze, if any; empty if
  /// nothing was recorded.
  std::vector<std::byte> replay(std::uint64_t state_hash, const std::string& glaze = {}) const;

 protected:
  /// `patience`: seconds that with_scene() and full queues wait for the loop.
  explicit WheelHost(double patience = 1.0);
  /// Lets the loop side take the sent commands (a stepped wheel applies them here; a thread needs
  /// time).
  virtual void let_loop_turn() = 0;

  WheelLoop core_;

 private:
  bool send(const Command& command);
  void take_returned();
  bool put_back();  ///< Puts lent_ back on the wheel.
  void note_records(Pot& pot);

  double patience_;
  WheelView view_;
  Pot* current_ = nullptr;     ///< On the wheel, owned by the core.
  std::unique_ptr<Pot> lent_;  ///< Returned by the core for with_scene().
  std::vector<std::unique_ptr<device::HandDevice>> devices_;
  std::uint32_t serial_ = 0;
  std::optional<ReplayWriter> recording_;
  std::uint64_t dropped_ = 0;
};

}  // namespace onggi::loop
