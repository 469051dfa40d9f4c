#include "engine/lab/closed_form.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi::lab::closed_form {
namespace {

// Gauss and Legendre's eight places and weights on -1..1, one half of each.
constexpr std::array<double, 4> kPlace{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                       0.9602898564975363};
constexpr std::array<double, 4> kWeight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                        0.1012285362903763};

template <class Function>
double integral(double from, double to, int parts, Function&& f) {
  double sum = 0.0;
  const double half = 0.5 * (to - from) / parts;
  for (int n = 0; n < parts; ++n) {
    const double middle = from + (2 * n + 1) * half;
    for (std::size_t k = 0; k < kPlace.size(); ++k)
      sum += kWeight[k] * (f(middle - half * kPlace[k]) + f(middle + half * kPlace[k]));
  }
  return half * sum;
}

double arc_cosine(double c) {
  return 0.5 * portable::kPi - portable::asin(std::clamp(c, -1.0, 1.0));
}

}  // namespace

double held_press(double press, double tau, double seconds) {
  return press * portable::exp(-seconds / tau);
}

double moving_press(double press, double speed, double tau, double seconds) {
  return speed * tau + (press - speed * tau) * portable::exp(-seconds / tau);
}

double lens_area(double a, double b, double apart) {
  if (apart >= a + b) return 0.0;
  if (apart <= std::fabs(a - b)) return portable::kPi * std::min(a, b) * std::min(a, b);
  const double by_a = (apart * apart + a * a - b * b) / (2.0 * apart * a);
  const double by_b = (apart * apart + b * b - a * a) / (2.0 * apart * b);
  const double kite = (a + b - apart) * (apart + a - b) * (apart - a + b) * (apart + a + b);
  return a * a * arc_cosine(by_a) + b * b * arc_cosine(by_b) - 0.5 * std::sqrt(std::max(kite, 0.0));
}

double lens_volume(double ball, double cylinder, double distance) {
  // Where a level circle of the ball just reaches the cylinder.
  const double least = distance - cylinder;
  if (least >= ball) return 0.0;
  const double high = least > 0.0 ? std::sqrt((ball - least) * (ball + least)) : ball;
  // y = high sin(a): the root at the ball's top is no corner in a.
  return 2.0 * integral(0.0, 0.5 * portable::kPi, 64, [&](double a) {
           const double y = high * portable::sin(a);
           const double r = std::sqrt(std::max((ball - y) * (ball + y), 0.0));
           return lens_area(r, cylinder, distance) * high * portable::cos(a);
         });
}

double light_force(double ball, double cylinder, double depth, double stiffness) {
  const double round = ball * cylinder / (ball + cylinder);
  return stiffness * portable::kPi * depth * depth * std::sqrt(round * ball);
}

double flat_force(double ball, double depth, double stiffness) {
  constexpr int kRings = 4000;
  const double above = ball - depth;
  const double wide = std::sqrt((ball - above) * (ball + above));
  double sum = 0.0;
  for (int n = 0; n < kRings; ++n) {
    const double out = wide * (n + 0.5) / kRings;
    const double down = std::sqrt((ball - out) * (ball + out));
    sum += (down - above) * down / ball * out;
  }
  return stiffness * 2.0 * portable::kPi * sum * wide / kRings;
}

double groove(double outer, double ball, double distance, double above) {
  if (std::fabs(above) >= ball) return outer;
  return std::min(outer, distance - std::sqrt((ball - above) * (ball + above)));
}

double weight_above(const ConicWall& wall, double from, double density) {
  const double share = from / wall.height;
  const auto frustum = [&](double foot, double rim) {
    const double there = foot + share * (rim - foot);
    return portable::kPi / 3.0 * (wall.height - from) * (there * there + there * rim + rim * rim);
  };
  return 9.81 * density *
         (frustum(wall.foot_outer, wall.rim_outer) - frustum(wall.foot_inner, wall.rim_inner));
}

double sagging_stress(double stress, double yield, double viscosity, double seconds) {
  if (stress <= yield) return stress;
  // (w - yield) / w falls as an exponential.
  const double over = (stress - yield) / stress;
  return yield / (1.0 - over * portable::exp(-yield * seconds / (3.0 * viscosity)));
}

double sagged_end(double from, double to, double stands) {
  const double yields = std::max(from, stands);
  return to > yields ? to - yields - stands * portable::log(to / yields) : 0.0;
}

}  // namespace onggi::lab::closed_form
