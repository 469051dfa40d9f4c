#include "kiosk/visit/sound/synthesis.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi::sound {

namespace {

constexpr unsigned kTuned = 16;  // samples between two changes of a filter
constexpr double kLeast = 1e-4;  // m/s and N: smaller values count as rest

// Saturates: from 0 towards 1 as x grows; 0.5 at x = `half`.
double saturated(double x, double half) { return x / (x + half); }

double clamped_magnitude(double x, double most) {
  return std::isfinite(x) ? std::clamp(std::fabs(x), 0.0, most) : 0.0;
}

// At most 1, linear at low level, like a tube (Pade's tanh).
double soft_clipped(double x) {
  const double t = std::clamp(x, -3.0, 3.0);
  return t * (27.0 + t * t) / (27.0 + 9.0 * t * t);
}

struct Timbre {
  double low, high;  // Hz of the band, at rest and at speed
  double q, loud;
};

constexpr Timbre timbre_of(Rub::Kind kind) {
  switch (kind) {
    case Rub::Kind::sponge:
      return {180.0, 620.0, 0.5, 0.8};
    case Rub::Kind::rib:
      return {700.0, 3600.0, 1.4, 0.7};
    case Rub::Kind::wire:
      return {1500.0, 3200.0, 7.0, 1.0};
    case Rub::Kind::hand:
      break;
  }
  return {320.0, 2000.0, 0.8, 1.0};
}

}  // namespace

double Synthesis::RubVoice::next(const Rub& rub, double wet, bool tune) noexcept {
  const double slip = clamped_magnitude(rub.slip, 20.0), push = clamped_magnitude(rub.push, 50.0);
  const bool rubs = slip > kLeast && push > kLeast;
  const Timbre timbre = timbre_of(rub.kind);
  const double haste = pitch.to(saturated(slip, 0.8));
  const double gain =
      loud.to(rubs ? timbre.loud * saturated(push, 1.2) * std::sqrt(saturated(slip, 0.4)) : 0.0);
  if (gain == 0.0) return 0.0;
  if (tune) {
    // Wetness changes the sound: dry clay hisses, slip whispers.
    const double dull = 1.0 - 0.4 * wet;
    const double hz = dull * (timbre.low + (timbre.high - timbre.low) * haste);
    body.tune(hz, timbre.q);
    if (rub.kind == Rub::Kind::sponge)
      breath.tune(7.0 + 9.0 * haste, 0.5);
    else
      breath.tune(1.6 * hz, 0.7);  // a band alone leaves a hiss far above it
  }
  const double in = noise.next();
  double out = body.next(in);
  if (rub.kind == Rub::Kind::sponge) {
    // Water is pressed out and drawn in again, about ten times a second.
    breath.next(squelch.next());
    out = 1.6 * body.low() * std::clamp(0.7 + 14.0 * breath.low(), 0.0, 1.6);
  } else {
    breath.next(1.4 * out);
    out = breath.low();
  }
  return 0.55 * gain * out;
}

// A wall that rings has two partials of a struck shell; a dull one is a thump of noise. Both fade,
// the wet one sooner.
double Synthesis::KnockVoice::next(const Knock& knock, double wet) noexcept {
  const double force = clamped_magnitude(knock.force, 2000.0);
  if (const bool now = force > 0.0; now != lies) {
    lies = now;
    if (now) left = saturated(force, 40.0), thump.tune(150.0, 0.7);
  }
  const double ring = 1.0 - std::min(1.0, 2.0 * wet);
  const double lasts = 0.022 + 0.05 * ring;  // s
  left = left > 1e-5 ? left * (1.0 - 1.0 / (lasts * kRate)) : 0.0;
  const double gain = loud.to(left);
  if (gain == 0.0) return 0.0;
  const double body = thump.next(noise.next());
  const double tones = 0.7 * low.next(210.0 + 160.0 * ring) + 0.4 * high.next(530.0 + 430.0 * ring);
  return 0.5 * gain * ((1.3 - 0.8 * ring) * body + (0.25 + 0.75 * ring) * tones);
}

double Synthesis::FireVoice::next(double fire, bool tune) noexcept {
  const double gain = loud.to(std::min(clamped_magnitude(fire, 1.0), 1.0));
  if (gain == 0.0) return 0.0;
  if (tune) {
    rumble.tune(130.0, 0.6);
    crack.tune(1900.0, 1.2);
  }
  rumble.next(noise.next());
  // Three sparks a second, each lasting some milliseconds.
  const bool one = sparks.next() > 1.0 - 2.0 * 3.0 / kRate;
  const double flash = spark.to(one ? 60.0 : 0.0);
  return gain * (1.3 * rumble.low() * (0.75 + 0.25 * breath.next(0.13)) +
                 crack.next(0.25 * flash * sparks.next()));
}

double Synthesis::hum(double wheel) noexcept {
  const double speed = wheel_.to(clamped_magnitude(wheel, 100.0));
  if (speed < 0.05) return 0.0;
  // A 4:1 belt on a six-pole motor: 4 rad/s more are 16 Hz more.
  const double hz = 28.0 + 4.0 * speed;
  const double gain = 0.05 * saturated(speed, 6.0) * std::min(speed, 1.0);
  const double tone = partials_[0].next(hz) + 0.5 * partials_[1].next(2.0 * hz) +
                      0.22 * partials_[2].next(3.0 * hz);
  return gain * tone * (1.0 + 0.12 * turn_.next(speed / (2.0 * portable::kPi)));
}

void Synthesis::play(const Heard& heard, std::span<float> out) noexcept {
  const double volume = std::min(clamped_magnitude(heard.volume, 1.0), 1.0);
  const double wet_now = std::min(clamped_magnitude(heard.wet, 1.0), 1.0);
  for (float& sample : out) {
    const bool tune = sample_++ % kTuned == 0;
    const double wet = wet_.to(wet_now);
    double sum = hum(heard.wheel) + fire_.next(heard.fire, tune) + song_.next();
    for (std::size_t i = 0; i < rubs_.size(); ++i) sum += rubs_[i].next(heard.rub[i], wet, tune);
    for (std::size_t i = 0; i < knocks_.size(); ++i) sum += knocks_[i].next(heard.knock[i], wet);
    // Loudness is roughly the square, so that half of the slider sounds like half.
    const double level = volume_.to(volume);
    sample = static_cast<float>(soft_clipped(level * level * sum));
  }
}

}  // namespace onggi::sound
