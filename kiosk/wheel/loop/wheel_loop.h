#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "engine/scene/replay.h"
#include "engine/scene/scene.h"
#include "engine/script/script.h"
#include "kiosk/wheel/device/hand_device.h"
#include "kiosk/wheel/loop/coil_by_angle.h"
#include "kiosk/wheel/loop/leather_work.h"
#include "kiosk/wheel/loop/row_channel.h"
#include "kiosk/wheel/loop/status.h"
#include "kiosk/wheel/loop/wetness_by_row.h"
#include "kiosk/wheel/loop/wheel_command.h"

namespace onggi::loop {

/// Everything that belongs to one pot on the wheel. Made and destroyed on the main thread.
struct Pot {
  Pot(Scene made, std::uint32_t number);

  Scene scene;
  std::uint32_t serial;
  RowChannel rows;
  std::unique_ptr<WetnessByRow> wet;                  ///< Present if rows have their own wetness,
  std::unique_ptr<CoilByAngle> coil;                  ///< and if the pot is built of coils.
  moodycamel::ReaderWriterQueue<TickRecord> records;  ///< Loop to main thread; 16 s deep.
  std::uint64_t dropped_records = 0;  ///< Loop thread's; read after the pot returns.
};

/// What the loop returns, for the main thread to keep or destroy.
struct Returned {
  Pot* pot = nullptr;
  Script* script = nullptr;
  device::HandDevice* device = nullptr;
  force::LeatherOutline* wall = nullptr;
};

/// The loop thread's side of the wheel: takes commands, reads the hands or the script, steps the
/// scene, publishes rows and records. No call but the destructor locks, allocates or throws.
class WheelLoop {
 public:
  static constexpr std::size_t kMostDevices = 8;

  WheelLoop();
  ~WheelLoop();
  WheelLoop(const WheelLoop&) = delete;
  WheelLoop& operator=(const WheelLoop&) = delete;

  /// Main thread. False if the queue is full (256 commands wait), because the loop has stopped.
  bool send(const Command& command) noexcept { return commands_.try_enqueue(command); }
  /// Main thread: the next object that the loop has returned.
  bool take_returned(Returned& out) noexcept { return returned_.try_dequeue(out); }

  /// Loop side: applies the waiting commands.
  void take_commands() noexcept;
  /// Loop side: take_commands(), then one tick of `dt` seconds.
  void tick(double dt) noexcept;
  /// Loop side: several ticks in a row came too late. Forces fade out until that ends.
  void strained(bool late) noexcept { strained_ = late; }
  /// Loop side: age of the newest report in the last tick, s; below 0 if there is none.
  double device_age() const noexcept { return device_age_; }
  /// Loop side.
  LoopStatus status() const noexcept { return status_; }

 private:
  struct Attached {
    device::HandDevice* device = nullptr;
    int hand = 0;
  };

  void apply(const command::Put& wish) noexcept;
  void apply(const command::GiveBack& wish) noexcept;
  void apply(const command::Play& wish) noexcept;
  void apply(const command::Attach& wish) noexcept;
  void apply(const command::Detach& wish) noexcept;
  void apply(const command::Lead& wish) noexcept;
  void apply(const command::Take& wish) noexcept;
  void apply(const command::Hold& wish) noexcept;
  void apply(const command::Swing& wish) noexcept { swings_ = wish.swings; }
  void apply(const command::TurnWheel& wish) noexcept { asked_.wheel_speed = wish.rad_per_s; }
  void apply(const command::Water& wish) noexcept { asked_.water = wish.held; }
  void apply(const command::Fire& wish) noexcept { asked_.fire = wish.hangs; }
  void apply(const command::Renew&) noexcept { asked_.renew = true; }
  void apply(const command::Restore&) noexcept { asked_.restore = true; }
  void apply(const command::Pause& wish) noexcept;
  void apply(const command::Show&) noexcept { shown_ = true; }
  void apply(const command::Harden& wish) noexcept;
  void apply(const command::Decorate& wish) noexcept { leather_.hold(wish.tool, wish.turn); }
  void apply(const command::ClearFaults& wish) noexcept;

  void hand_back(const Returned& done) noexcept;
  void lift_hands() noexcept;
  void read_hands(double dt, Hands& hands) noexcept;
  void beat(double dt, HandInput& hand) noexcept;
  void feel(const std::array<HandFeedback, kMaxHands>& felt) noexcept;
  void step(double dt) noexcept;
  void decorate(double dt) noexcept;
  void end_leather(bool now) noexcept;

  moodycamel::ReaderWriterQueue<Command> commands_;
  moodycamel::ReaderWriterQueue<Returned> returned_;
  Pot* pot_ = nullptr;
  Script* script_ = nullptr;
  double script_time_ = 0;
  std::array<Attached, kMostDevices> devices_{};  ///< In order of arrival.
  std::size_t attached_ = 0;
  std::array<device::HandDevice*, kMaxHands> leads_{};  ///< The devices that led in the last tick.
  std::array<std::optional<std::uint8_t>, kMaxHands> taken_{};
  InHand in_hand_ = InHand::tool;
  Paddle paddle_;
  script::Swings swings_;
  bool led_ = false;  ///< The screens want hand 0 on the clay.
  double off_ = 0;    ///< s for which all hands stay off freshly laid clay.
  Hands asked_;       ///< Wheel, water and the one-tick requests; hands come from the devices.
  LeatherWork leather_;
  bool paused_ = false;
  bool shown_ = false;
  bool strained_ = false;
  double calm_ = 1.0;  ///< Share of the force that hands feel.
  double device_age_ = -1.0;
  LoopStatus status_;
};

}  // namespace onggi::loop
