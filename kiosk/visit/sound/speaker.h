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

/// The sound card, through SDL 2 (ALSA, PulseAudio, PipeWire; SDL_AUDIODRIVER names another). SDL's
/// thread asks for a block of kBlock samples; the speaker reads the state at that moment and plays
/// it, without lock, allocation or log. Sound is optional: without a card the kiosk is silent, and
/// it looks for a removed card again. Main thread, except where noted.
class Speaker {
 public:
  /// Samples in a block, 8 ms. The sound is at most one block old, and starts after the block
  /// before it.
  static constexpr int kBlock = 384;
  /// s between two searches for a missing card.
  static constexpr double kLookAgain = 30.0;

  /// SCHED_FIFO priority of SDL's thread, if the system permits it (LimitRTPRIO).
  static constexpr int kPriority = 70;

  /// SDL's thread calls `listen` for every block; it must not block or throw. volume() and fire()
  /// replace its volume and fire, rub() its first hand. A missing card is no error: see remark().
  explicit Speaker(std::function<Heard()> listen);
  ~Speaker();
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;

  void volume(double share) { volume_.store(share, std::memory_order_relaxed); }  ///< 0..1
  /// Played from the next block on.
  void sing(const OutlineSong& song);
  /// What a hand rubs besides the wheel's clay; its `push` 0: nothing.
  void rub(const Rub& rub) {
    rubbed_.store(static_cast<int>(rub.kind), std::memory_order_relaxed);
    rub_slip_.store(rub.slip, std::memory_order_relaxed);
    rub_push_.store(rub.push, std::memory_order_relaxed);
  }
  void fire(double share) { fire_.store(share, std::memory_order_relaxed); }  ///< 0..1
  /// Call once a frame, `now` in s on a clock that never goes back.
  void look(double now);
  /// A line for the log, each once: the card, or why there is none. Empty: nothing new.
  std::string remark();
  bool playing() const { return device_ != 0; }

  struct Status {
    std::uint64_t blocks = 0;
    std::uint64_t late = 0;       ///< Requests more than a block late: the card ran dry.
    double worst_gap_s = 0.0;     ///< Largest time between two requests.
    std::uint64_t touches = 0;    ///< How often a hand began to rub,
    std::int64_t touched_ns = 0;  ///< and when the last rub was heard, CLOCK_MONOTONIC: at the end
                                  ///< of the block before it.
  };
  Status status() const;  ///< Any thread.

 private:
  void open();
  void close();
  static void asked(void* self, unsigned char* out, int bytes) noexcept;
  void play(float* out, int samples) noexcept;

  std::function<Heard()> listen_;
  Synthesis synthesis_;  ///< SDL's thread only.
  bool rubs_ = false;    ///< SDL's thread only, like the time of the last request.
  std::int64_t asked_ns_ = 0;
  /// SDL's thread copies the newest song within a block, long before its slot is used again.
  std::array<OutlineSong, 4> songs_;
  std::atomic<unsigned> sung_{0};
  unsigned heard_song_ = 0;  ///< SDL's thread only.
  std::atomic<double> volume_{0.0}, fire_{0.0}, rub_slip_{0.0}, rub_push_{0.0};
  std::atomic<int> rubbed_{0};
  std::atomic<std::uint64_t> blocks_{0}, late_{0}, touches_{0};
  std::atomic<std::int64_t> worst_gap_ns_{0}, touched_ns_{0};
  std::string remark_, said_;
  bool sdl_ = false;
  std::uint32_t device_ = 0;
  double looked_ = 0.0;
};

}  // namespace onggi::sound
