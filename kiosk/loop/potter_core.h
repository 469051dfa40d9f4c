#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <array>
#include <cstdint>
#include <memory>

#include "engine/scene/replay.h"
#include "engine/scene/scene.h"
#include "engine/script/script.h"
#include "kiosk/device/pointer_hand.h"
#include "kiosk/loop/row_channel.h"
#include "kiosk/loop/status.h"
#include "kiosk/loop/wet_rows.h"

namespace onggi::loop {

/// Everything that belongs to one pot while it is on the wheel. Made and destroyed on the main
/// thread.
struct Pot {
  Pot(Scene made, std::uint32_t number);

  Scene scene;
  std::uint32_t serial;
  RowChannel rows;
  std::unique_ptr<WetRows> wet;                       ///< Where rows have a wetness of their own.
  moodycamel::ReaderWriterQueue<TickRecord> records;  ///< Loop to main; 16 s deep.
  std::uint64_t dropped_records = 0;                  ///< Loop's; read once the pot is back.
};

/// One wish of the main thread. Pointers are owned by whoever holds the command.
struct Command {
  enum class Kind : std::uint8_t {
    put,
    give_back,
    play,
    hand,
    wheel,
    water,
    renew,
    restore,
    pause
  };
  Kind kind = Kind::pause;
  int index = 0;
  bool on = false;
  double value = 0;
  HandInput target;
  Pot* pot = nullptr;
  Script* script = nullptr;
};

/// What the loop side is done with, for the main thread to keep or destroy.
struct Returned {
  Pot* pot = nullptr;
  Script* script = nullptr;
};

/// The wheel as the loop thread knows it: takes commands, reads the hands or the script, steps the
/// scene, publishes rows and records. No lock, no allocation, no throw in any call but the
/// destructor.
class PotterCore {
 public:
  PotterCore();
  ~PotterCore();
  PotterCore(const PotterCore&) = delete;
  PotterCore& operator=(const PotterCore&) = delete;

  /// Main thread. False when the queue is full (256 commands wait): the loop stands still.
  bool send(const Command& command) noexcept { return commands_.try_enqueue(command); }
  /// Main thread: the next thing the loop has handed back.
  bool take_returned(Returned& out) noexcept { return returned_.try_dequeue(out); }

  /// Loop side: applies the commands that wait.
  void take_commands() noexcept;
  /// Loop side: take_commands(), then one tick of `dt` seconds.
  void tick(double dt) noexcept;
  /// Loop side.
  LoopStatus status() const noexcept { return status_; }

 private:
  void apply(const Command& command) noexcept;
  void hand_back(Pot* pot, Script* script) noexcept;
  Hands gather(double dt) noexcept;

  moodycamel::ReaderWriterQueue<Command> commands_;
  moodycamel::ReaderWriterQueue<Returned> returned_;
  Pot* pot_ = nullptr;
  Script* script_ = nullptr;
  double script_time_ = 0;
  std::array<device::PointerHand, kMaxHands> pointers_;
  Hands asked_;  ///< Wheel, water and the one-tick wishes; hands come from the devices.
  bool paused_ = false;
  LoopStatus status_;
};

}  // namespace onggi::loop
