#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "engine/base/result.h"
#include "kiosk/visit/sound/heard.h"
#include "kiosk/visit/sound/synthesis.h"

struct SDL_AudioSpec;

namespace onggi::sound {

/// The sound card, by SDL 2 (ALSA, PulseAudio, PipeWire; SDL_AUDIODRIVER names another). A thread
/// of SDL's asks for a block of kBlock samples, hears what is so at that moment and plays it: no
/// lock, no allocation, no log there. Nothing of it is needed for play: without a card there is
/// silence, and one that is pulled out is looked for again. Main thread, but for what says
/// otherwise.
class Speaker {
 public:
  /// Samples in a block, 8 ms: what is heard is as old as a block at the most, and begins to sound
  /// when the one before it has ended.
  static constexpr int kBlock = 384;
  /// s after which a card that is gone is looked for again.
  static constexpr double kLookAgain = 30.0;

  /// SCHED_FIFO of SDL's thread, where the system permits it (LimitRTPRIO); else it is as others.
  static constexpr int kPriority = 70;

  /// `listen` is called from SDL's thread for every block; it neither blocks nor throws. Its volume
  /// and fire are those of volume() and fire(). A machine without a card is no error: see remark().
  explicit Speaker(std::function<Heard()> listen);
  ~Speaker();
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;

  void volume(double share) { volume_.store(share, std::memory_order_relaxed); }  ///< 0..1
  /// Heard from the next block on.
  void sing(const OutlineSong& song);
  void fire(double share) { fire_.store(share, std::memory_order_relaxed); }  ///< 0..1
  /// Once a frame, `now` in s on a clock that never goes back.
  void look(double now);
  /// A line for the log, once each: which card plays, or why none does. Empty: nothing new.
  std::string remark();
  bool playing() const { return device_ != 0; }

  struct Status {
    std::uint64_t blocks = 0;
    std::uint64_t late = 0;       ///< Asked for over a block after its time: the card ran dry.
    double worst_gap_s = 0.0;     ///< Between two that were asked for.
    std::uint64_t touches = 0;    ///< Times that a hand began to rub,
    std::int64_t touched_ns = 0;  ///< and when the last of them came out, CLOCK_MONOTONIC: the end
                                  ///< of the block before it.
  };
  Status status() const;  ///< Any thread.

 private:
  void open();
  void close();
  static void asked(void* self, unsigned char* out, int bytes) noexcept;
  void play(float* out, int samples) noexcept;

  std::function<Heard()> listen_;
  Synthesis synthesis_;  ///< SDL's thread.
  bool rubs_ = false;    ///< Likewise, and when the last block was asked for.
  std::int64_t asked_ns_ = 0;
  /// The newest is copied by SDL's thread within a block, long before its place is needed again.
  std::array<OutlineSong, 4> songs_;
  std::atomic<unsigned> sung_{0};
  unsigned heard_song_ = 0;  ///< SDL's thread.
  std::atomic<double> volume_{0.0}, fire_{0.0};
  std::atomic<std::uint64_t> blocks_{0}, late_{0}, touches_{0};
  std::atomic<std::int64_t> worst_gap_ns_{0}, touched_ns_{0};
  std::string remark_, said_;
  bool sdl_ = false;
  std::uint32_t device_ = 0;
  double looked_ = 0.0;
};

}  // namespace onggi::sound
