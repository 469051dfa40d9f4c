#include "engine/lab/sampled_theory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "engine/contact/paper_model.h"
#include "engine/math/portable.h"

namespace onggi::lab::theory {

namespace {

using Complex = std::complex<double>;

// State: place, speed, the wall's own two, and the forces on their way.
constexpr std::size_t kSize = 4 + DeviceModel::kMostDelay;
using Matrix = std::array<std::array<double, kSize>, kSize>;

constexpr double kStiffest = 1e6;  // N/m
// Clay that gives way lets a handle stay anywhere: an eigenvalue of 1, to rounding.
constexpr double kNotGrowing = 1.0 + 1e-11;

/// Coefficients of B(z) = b (1 + z^-1)^2 / (1 + a1 z^-1 + a2 z^-2).
struct Butterworth {
  double b, a1, a2;
};

Butterworth butterworth(double seconds) {
  const double angle = portable::kPi * PaperFilter::kCutoff * seconds;
  const double k = portable::sin(angle) / portable::cos(angle);
  const double norm = 1.0 / (1.0 + std::sqrt(2.0) * k + k * k);
  return {k * k * norm, 2.0 * (k * k - 1.0) * norm, (1.0 - std::sqrt(2.0) * k + k * k) * norm};
}

Complex response(SampledWall wall, Complex back, double seconds) {
  switch (wall) {
    case SampledWall::maxwell:
      return (1.0 - back) / (1.0 - portable::exp(-seconds / kRelaxation) * back);
    case SampledWall::filtered_spring: {
      const Butterworth f = butterworth(seconds);
      return f.b * (1.0 + back) * (1.0 + back) / (1.0 + f.a1 * back + f.a2 * back * back);
    }
    case SampledWall::spring:
      break;
  }
  return 1.0;
}

/// x and v after one tick: by a constant force of 1 N (last column), or by themselves.
struct Motion {
  std::array<std::array<double, 3>, 2> rows;
};

Motion motion_of(const DeviceModel& device, const HandModel& hand, double seconds) {
  const double mass = device.mass + hand.mass;
  using Three = std::array<std::array<double, 3>, 3>;
  // e^(A t) by scaling and squaring of Taylor's series.
  constexpr int kSampledHalvings = 10;
  const double t = seconds / (1 << kSampledHalvings);
  const Three a{
      {{0.0, t, 0.0},
       {-hand.stiffness / mass * t, -(device.damping + hand.damping) / mass * t, t / mass},
       {0.0, 0.0, 0.0}}};
  const auto times = [](const Three& p, const Three& q) {
    Three r{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) r[i][j] += p[i][k] * q[k][j];
    return r;
  };
  Three sum{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  Three term = sum;
  for (int n = 1; n <= 8; ++n) {
    term = times(term, a);
    for (auto& row : term)
      for (double& value : row) value /= n;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sum[i][j] += term[i][j];
  }
  for (int n = 0; n < kSampledHalvings; ++n) sum = times(sum, sum);
  return {{{sum[0], sum[1]}}};
}

Matrix system_of(SampledWall wall, double stiffness, const DeviceModel& device,
                 const HandModel& hand, double seconds) {
  // s = {x, v, w1, w2, f_1 .. f_delay}; the wall's answer to x is linear in x and its own two.
  std::array<double, 4> answer{-stiffness, 0.0, 0.0, 0.0};
  std::array<std::array<double, 4>, 2> own{};
  if (wall == SampledWall::maxwell) {
    // w1: the force of the last tick; w2: the last place.
    answer = {-stiffness, 0.0, portable::exp(-seconds / kRelaxation), stiffness};
    own = {{answer, {1.0, 0.0, 0.0, 0.0}}};
  } else if (wall == SampledWall::filtered_spring) {
    // Transposed direct form.
    const Butterworth f = butterworth(seconds);
    const double in = -stiffness;
    answer = {f.b * in, 0.0, 1.0, 0.0};
    own[0] = {2.0 * f.b * in - f.a1 * answer[0], 0.0, -f.a1, 1.0};
    own[1] = {f.b * in - f.a2 * answer[0], 0.0, -f.a2, 0.0};
  }
  Matrix m{};
  const Motion motion = motion_of(device, hand, seconds);
  for (std::size_t i = 0; i < 2; ++i) {
    m[i][0] = motion.rows[i][0];
    m[i][1] = motion.rows[i][1];
    const double by_force = motion.rows[i][2];
    if (device.delay == 0)
      for (std::size_t j = 0; j < 4; ++j) m[i][j] += by_force * answer[j];
    else
      m[i][3 + static_cast<std::size_t>(device.delay)] = by_force;
    for (std::size_t j = 0; j < 4; ++j) m[2 + i][j] = own[i][j];
  }
  if (device.delay > 0)
    for (std::size_t j = 0; j < 4; ++j) m[4][j] = answer[j];
  for (int d = 1; d < device.delay; ++d) {
    const auto at = static_cast<std::size_t>(4 + d);
    m[at][at - 1] = 1.0;
  }
  return m;
}

}  // namespace

double passive_damping(SampledWall wall, int delay, double seconds) {
  constexpr int kAngles = 4000;
  double most = 0.0;
  for (int n = 1; n <= kAngles; ++n) {
    const double angle = portable::kPi * n / kAngles;
    const Complex back(portable::cos(angle), -portable::sin(angle));
    Complex late = 1.0;
    for (int d = 0; d < delay; ++d) late *= back;
    const double real = ((1.0 - back) * response(wall, back, seconds) * late).real();
    most = std::max(most, 0.5 * seconds * real / (1.0 - portable::cos(angle)));
  }
  return most;
}

double stiffest_passive(SampledWall wall, const DeviceModel& device, double seconds) {
  return device.damping / passive_damping(wall, device.delay, seconds);
}

double spectral_radius(SampledWall wall, double stiffness, const DeviceModel& device,
                       const HandModel& hand, double seconds) {
  // Growth of the 2^n-th power's norm from one squaring to the next. The ratio cancels units and
  // initial state.
  Matrix power = system_of(wall, stiffness, device, hand, seconds);
  constexpr int kSquarings = 30;
  double logarithm = 0.0, exponent = 1.0, grown = 0.0;
  for (int n = 0; n <= kSquarings; ++n) {
    double norm = 0.0;
    for (const auto& row : power)
      for (const double value : row) norm += value * value;
    norm = std::sqrt(norm);
    if (!(norm > 0.0)) return 0.0;
    const double before = logarithm;
    logarithm = 2.0 * logarithm + portable::log(norm);
    if (n > 0) {
      grown = (logarithm - before) / exponent;
      exponent *= 2.0;
    }
    Matrix next{};
    for (std::size_t i = 0; i < kSize; ++i)
      for (std::size_t k = 0; k < kSize; ++k) {
        const double left = power[i][k] / norm;
        for (std::size_t j = 0; j < kSize; ++j) next[i][j] += left * power[k][j] / norm;
      }
    power = next;
  }
  return portable::exp(grown);
}

double stiffest_stable(SampledWall wall, const DeviceModel& device, const HandModel& hand,
                       double seconds) {
  const auto stable = [&](double stiffness) {
    return spectral_radius(wall, stiffness, device, hand, seconds) < kNotGrowing;
  };
  if (stable(kStiffest)) return kStiffest;
  // From below, step by step, because a loop may become stable again for stiffer walls.
  double low = 0.0, high = 1.0;
  while (stable(high)) {
    low = high;
    high *= 1.3;
  }
  for (int n = 0; n < 40; ++n) {
    const double middle = 0.5 * (low + high);
    (stable(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace onggi::lab::theory
