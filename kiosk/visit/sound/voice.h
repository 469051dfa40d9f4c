#pragma once

#include <cstdint>

namespace onggi::sound {

/// Samples a second, for everything here.
inline constexpr double kRate = 48000.0;

/// A value that follows its target without jumps, because a jump is a click: a one-pole low-pass
/// that has covered two thirds of the way after `seconds`.
class Glide {
 public:
  explicit Glide(double seconds) noexcept;
  double to(double wanted) noexcept {
    at_ += pace_ * (wanted - at_);
    // A tail below the last of 24 bits is inaudible, and denormal numbers are slow.
    if (wanted == 0.0 && at_ < 1e-7) at_ = 0.0;
    return at_;
  }

 private:
  double pace_, at_ = 0.0;
};

/// White noise from -1 to 1; a seed gives the same noise everywhere (xorshift: Marsaglia 2003).
class Noise {
 public:
  explicit Noise(std::uint32_t seed) noexcept : state_(seed | 1u) {}
  double next() noexcept {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return static_cast<double>(state_) * 0x1p-31 - 1.0;
  }

 private:
  std::uint32_t state_;
};

/// A second-order filter whose frequency may change while it plays (trapezoidal state-variable
/// filter: Zavalishin, The Art of VA Filter Design, 2012, chapter 4). `next` returns its band-pass,
/// at most 1 at the middle; `low` is its low-pass.
class Band {
 public:
  /// `hz` 20..15000, `q` 0.3..20: middle over width.
  void tune(double hz, double q) noexcept;
  double next(double in) noexcept {
    const double v3 = in - low_;
    const double v1 = a1_ * band_ + a2_ * v3;
    const double v2 = low_ + a2_ * band_ + a3_ * v3;
    band_ = 2.0 * v1 - band_;
    low_ = 2.0 * v2 - low_;
    below_ = v2;
    return damping_ * v1;
  }
  double low() const noexcept { return below_; }

 private:
  double a1_ = 1.0, a2_ = 0.0, a3_ = 0.0, damping_ = 1.0;
  double band_ = 0.0, low_ = 0.0, below_ = 0.0;
};

/// A tone whose pitch may change at any sample without a click.
class Tone {
 public:
  /// Phase in turns; `hz` below kRate / 2.
  double next(double hz) noexcept {
    turn_ += hz / kRate;
    turn_ -= static_cast<double>(static_cast<int>(turn_));
    return sine(turn_);
  }
  /// sin(2 pi turn) by Bhaskara's fraction, 0.2 % off: its harmonics are 50 dB below it.
  static double sine(double turn) noexcept {
    const double half = turn < 0.5 ? turn : turn - 0.5;
    const double p = half * (0.5 - half);
    const double s = 16.0 * p / (1.25 - 4.0 * p);
    return turn < 0.5 ? s : -s;
  }

 private:
  double turn_ = 0.0;
};

}  // namespace onggi::sound
