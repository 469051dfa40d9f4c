#include "kiosk/collection/content/drawn_outline.h"

#include <algorithm>
#include <cmath>

namespace onggi::content {

namespace {

/// Slope at a knot from the chords before and after it (Fritsch and Butland 1984): their weighted
/// harmonic mean, 0 where they disagree in sign. Keeps the cubic monotone.
double monotone_slope(double before, double after, double length_before, double length_after) {
  if (before * after <= 0.0) return 0.0;
  const double w1 = 2.0 * length_after + length_before;
  const double w2 = length_after + 2.0 * length_before;
  return (w1 + w2) / (w1 / before + w2 / after);
}

/// Slope at an end: of the parabola through three knots, held within what keeps it monotone.
double end_slope(double chord, double next, double length, double length_next) {
  const double slope =
      ((2.0 * length + length_next) * chord - length * next) / (length + length_next);
  if (slope * chord <= 0.0) return 0.0;
  if (chord * next <= 0.0 && std::abs(slope) > 3.0 * std::abs(chord)) return 3.0 * chord;
  return slope;
}

std::vector<double> slopes(const std::vector<double>& values, const std::vector<double>& lengths) {
  const std::size_t n = values.size();
  std::vector<double> chords(n - 1), out(n);
  for (std::size_t i = 0; i + 1 < n; ++i) chords[i] = (values[i + 1] - values[i]) / lengths[i];
  if (n == 2) return {chords[0], chords[0]};
  for (std::size_t i = 1; i + 1 < n; ++i)
    out[i] = monotone_slope(chords[i - 1], chords[i], lengths[i - 1], lengths[i]);
  out[0] = end_slope(chords[0], chords[1], lengths[0], lengths[1]);
  out[n - 1] = end_slope(chords[n - 2], chords[n - 3], lengths[n - 2], lengths[n - 3]);
  return out;
}

double hermite(double a, double slope_a, double b, double slope_b, double length, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * length * slope_a + (3 * t2 - 2 * t3) * b +
         (t3 - t2) * length * slope_b;
}

/// Appends the smooth run from knot `first` to knot `last`, without its first point.
void append_run(const std::vector<Knot>& knots, std::size_t first, std::size_t last, double link,
                bool level_end, Outline& out) {
  std::vector<double> x, y, lengths;
  for (std::size_t i = first; i <= last; ++i) {
    x.push_back(knots[i].at.x);
    y.push_back(knots[i].at.y);
    if (i < last) lengths.push_back(length(knots[i + 1].at - knots[i].at));
  }
  const std::vector<double> dx = slopes(x, lengths);
  std::vector<double> dy = slopes(y, lengths);
  if (level_end) dy.back() = 0.0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const int links = std::clamp(static_cast<int>(std::ceil(lengths[i] / link)), 1, 64);
    for (int k = 1; k <= links; ++k) {
      const double t = static_cast<double>(k) / links;
      out.points.push_back({hermite(x[i], dx[i], x[i + 1], dx[i + 1], lengths[i], t),
                            hermite(y[i], dy[i], y[i + 1], dy[i + 1], lengths[i], t)});
      out.drawn.push_back(first + i + (2 * k > links ? 1 : 0));
    }
    out.points.back() = knots[first + i + 1].at;
  }
}

bool segments_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 &&
         cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double t = std::clamp(dot(p - a, ab) / std::max(dot(ab, ab), 1e-300), 0.0, 1.0);
  return length(p - (a + ab * t));
}

}  // namespace

Outline smooth_outline(const std::vector<Knot>& knots, double link, bool level_end) {
  Outline out;
  out.points.push_back(knots.front().at);
  out.drawn.push_back(0);
  std::size_t first = 0;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const bool last = i + 1 == knots.size();
    if (!last && !knots[i].corner) continue;
    append_run(knots, first, i, link, level_end && last && !knots[i].corner, out);
    first = i;
  }
  return out;
}

Outline straight_outline(const std::vector<Knot>& knots) {
  Outline out;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    out.points.push_back(knots[i].at);
    out.drawn.push_back(i);
  }
  return out;
}

std::optional<Narrow> too_near(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double least,
                               double skip) {
  std::optional<Narrow> worst;
  double along = 0.0;
  for (std::size_t i = 1; i < b.size(); ++i) {
    along += length(b[i] - b[i - 1]);
    double nearest = 1e300;
    for (std::size_t k = 1; k < a.size(); ++k) {
      if (segments_cross(a[k - 1], a[k], b[i - 1], b[i])) return Narrow{i, 0.0};
      nearest = std::min({nearest, distance_to_segment(b[i], a[k - 1], a[k]),
                          distance_to_segment(a[k], b[i - 1], b[i])});
    }
    if (along > skip && nearest < least && (!worst || nearest < worst->distance))
      worst = Narrow{i, nearest};
  }
  return worst;
}

std::optional<std::size_t> self_crossing(const std::vector<Vec2>& chain) {
  for (std::size_t i = 1; i < chain.size(); ++i)
    for (std::size_t k = i + 2; k < chain.size(); ++k)
      if (segments_cross(chain[i - 1], chain[i], chain[k - 1], chain[k])) return k;
  return std::nullopt;
}

Vec2 shorten(std::vector<Vec2>& chain, double amount) {
  while (chain.size() > 2 && length(chain.back() - chain[chain.size() - 2]) <= amount) {
    amount -= length(chain.back() - chain[chain.size() - 2]);
    chain.pop_back();
  }
  const Vec2 from = chain[chain.size() - 2];
  const double left = length(chain.back() - from);
  chain.back() = chain.back() + (from - chain.back()) * std::min(0.95, amount / left);
  return chain.back();
}

std::vector<Vec2> arc(Vec2 from, Vec2 corner, Vec2 to) {
  // A cubic whose handles reach this far towards the corner is a quarter circle to 0.03 %.
  constexpr double kHandle = 0.5522847498307936;
  constexpr int kLinks = 8;
  const Vec2 a = from + (corner - from) * kHandle;
  const Vec2 b = to + (corner - to) * kHandle;
  std::vector<Vec2> out;
  for (int i = 0; i <= kLinks; ++i) {
    const double t = static_cast<double>(i) / kLinks, s = 1.0 - t;
    out.push_back(from * (s * s * s) + a * (3 * s * s * t) + b * (3 * s * t * t) +
                  to * (t * t * t));
  }
  return out;
}

}  // namespace onggi::content
