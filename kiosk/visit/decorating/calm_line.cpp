#include "kiosk/visit/decorating/calm_line.h"

#include <cmath>

namespace onggi::decorating {

namespace {
constexpr double kCurvePiece = 0.002;  // m
constexpr double kWholeAngle = 2.0 * 3.14159265358979;
}  // namespace

CalmPart calm_part(const surface::HandPlace& drawn, const surface::HandPlace& tip, double along,
                   double turns, double radius) {
  const double far = std::hypot(along - tip.along, turns * kWholeAngle * radius);
  if (far <= kSlack) return {{}, tip};
  const double share = (far - kSlack) / far;
  CalmPart part{{}, {tip.along + share * (along - tip.along), tip.turns + share * turns}};
  const surface::HandPlace middle{0.5 * (tip.along + part.tip.along),
                                  0.5 * (tip.turns + part.tip.turns)};
  const int pieces = 1 + static_cast<int>(far / kCurvePiece);
  for (int n = 1; n <= pieces; ++n) {
    const double t = static_cast<double>(n) / pieces, u = 1.0 - t;
    const auto curve = [&](double a, double b, double c) {
      return u * u * a + 2.0 * u * t * b + t * t * c;
    };
    part.way.push_back(
        {curve(drawn.along, tip.along, middle.along), curve(drawn.turns, tip.turns, middle.turns)});
  }
  return part;
}

}  // namespace onggi::decorating
