#include "kiosk/exhibit/rehearsal/looks_smooth.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace onggi::rehearsal {

namespace {
constexpr double kStep = 0.0005, kWindow = 0.010, kLedgeStep = 0.001;
constexpr double kMostRoughness = 0.0003, kMostLedge = 0.002;
}  // namespace

Smoothness smoothness(const Profile& made) {
  Smoothness out;
  const int n = static_cast<int>(made.height() / kStep);
  const int half = static_cast<int>(0.5 * kWindow / kStep + 0.5);
  if (n < 4 * half) return out;
  std::vector<double> r;
  for (int i = 0; i <= n; ++i) r.push_back(made.outer_at(kStep * i));
  double squares = 0;
  int count = 0;
  for (int i = half; i + half <= n; ++i) {
    double mean = 0;
    for (int k = -half; k <= half; ++k) mean += r[static_cast<std::size_t>(i + k)] / (2 * half + 1);
    const double off = r[static_cast<std::size_t>(i)] - mean;
    squares += off * off;
    ++count;
  }
  out.roughness = std::sqrt(squares / count);
  const int step = static_cast<int>(kLedgeStep / kStep + 0.5);
  for (int i = 0; i + step <= n; ++i) {
    const int low = std::clamp(i + step / 2 - half, 0, n - 2 * half), high = low + 2 * half;
    const double slope =
        (r[static_cast<std::size_t>(high)] - r[static_cast<std::size_t>(low)]) / (high - low);
    const double jump = r[static_cast<std::size_t>(i + step)] - r[static_cast<std::size_t>(i)];
    out.ledge = std::max(out.ledge, std::fabs(jump - slope * step));
  }
  return out;
}

bool looks_smooth(const Smoothness& s) {
  return s.roughness < kMostRoughness && s.ledge < kMostLedge;
}

double outline_distance(const Profile& a, const Profile& b) {
  const int n = static_cast<int>(std::min(a.height(), b.height()) / kStep);
  double squares = 0;
  for (int i = 0; i <= n; ++i) {
    const double off = a.outer_at(kStep * i) - b.outer_at(kStep * i);
    squares += off * off;
  }
  return std::max(std::sqrt(squares / (n + 1)), std::fabs(a.height() - b.height()));
}

}  // namespace onggi::rehearsal
