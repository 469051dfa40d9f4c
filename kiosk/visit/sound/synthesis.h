#pragma once

#include <array>
#include <span>

#include "kiosk/visit/sound/heard.h"
#include "kiosk/visit/sound/outline_song.h"
#include "kiosk/visit/sound/voice.h"

namespace onggi::sound {

/// Synthesises a quiet studio: the wheel's hum by its speed; clay rubbing on a hand, a sponge, a
/// rib or a wire, by slip and push; a paddle's blows; and a kiln. No recordings; the same inputs
/// give the same samples everywhere. Samples stay in -1..1 for any input, and a jump of an input
/// makes no click. No allocation, no lock: it runs on the sound card's thread.
class Synthesis {
 public:
  /// Fills `out` with samples of one channel, kRate a second, for the state `heard`. A new touch
  /// reaches two thirds of its loudness after 3 ms.
  void play(const Heard& heard, std::span<float> out) noexcept;
  /// Starts at the next sample, over the other sounds.
  void sing(const OutlineSong& song) noexcept { song_.sing(song); }

 private:
  /// Rubbing: noise through a band, plus the sound of a sponge or a wire.
  struct RubVoice {
    explicit RubVoice(std::uint32_t seed) noexcept : noise(seed), squelch(seed + 7) {}
    Noise noise, squelch;
    Band body, breath;
    Glide loud{0.003}, pitch{0.02};
    double next(const Rub& rub, double wet, bool tune) noexcept;
  };
  struct FireVoice {
    Noise noise{11}, sparks{23};
    Band rumble, crack;
    Glide loud{0.5}, spark{0.002};
    Tone breath;
    double next(double fire, bool tune) noexcept;
  };

  /// A blow of a paddle: dull on wet clay, ringing on clay that is ready to be beaten.
  struct KnockVoice {
    explicit KnockVoice(std::uint32_t seed) noexcept : noise(seed) {}
    Noise noise;
    Band thump;
    Tone low, high;
    Glide loud{0.0008};
    double left = 0.0;  // of the last blow's loudness
    bool lies = false;
    double next(const Knock& knock, double wet) noexcept;
  };

  double hum(double wheel) noexcept;

  std::array<RubVoice, kMaxHands> rubs_{RubVoice{3}, RubVoice{5}};
  std::array<KnockVoice, kMaxHands> knocks_{KnockVoice{31}, KnockVoice{37}};
  FireVoice fire_;
  OutlineVoice song_;
  std::array<Tone, 3> partials_;
  Tone turn_;
  Glide wheel_{0.15}, wet_{0.2}, volume_{0.02};
  unsigned sample_ = 0;
};

}  // namespace onggi::sound
