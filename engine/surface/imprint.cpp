#include "engine/surface/imprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/math/portable.h"

namespace onggi::surface {

namespace {

using portable::kPi;

constexpr int kAcross = 64;         // of a pattern's picture
constexpr double kTwist = 1.6;      // pitches from strand to strand along a cord
constexpr double kBar = 0.30;       // of the pitch: the ridge that a cut in the paddle leaves
constexpr double kEdge = 0.25;      // of a smoothed field's half: it runs out over so much
constexpr float kCovered = 0.002f;  // what is left of a cell that nothing below shows through

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// How deep one repeat of a face is, 0..1: `x`, `y` in repeats, 0..1.
double cord(double x, double y) {
  const double off = 2.0 * x - 1.0;  // from the cord's middle
  const double strand = 0.5 + 0.5 * portable::cos(2.0 * kPi * (y - 0.5 * off));
  return (1.0 - off * off) * (0.55 + 0.45 * std::sqrt(strand));
}
double grid(double x, double y) {
  const auto cut = [](double t) {
    return smooth_step(0.3 * kBar, 0.8 * kBar, std::min(t, 1.0 - t));
  };
  return cut(x) * cut(y);
}
// By the distance from the middle.
double rings(double x, double) { return 0.5 + 0.5 * portable::cos(2.0 * kPi * x); }

class Pattern {
 public:
  Pattern(int face, const ImprintDef& def) : round_(face == Impression::rings) {
    x_ = 1.0 / (round_ ? def.rings : def.pitch);
    y_ = face == Impression::cord ? x_ / kTwist : x_;
    if (face == Impression::even) return;
    for (int row = 0; row < kAcross; ++row)
      for (int i = 0; i < kAcross; ++i) {
        const double x = (i + 0.5) / kAcross, y = (row + 0.5) / kAcross;
        deep_[static_cast<std::size_t>(row * kAcross + i)] =
            static_cast<float>(round_                     ? rings(x, y)
                               : face == Impression::cord ? cord(x, y)
                                                          : grid(x, y));
      }
  }
  float at(double x, double y) const {
    if (round_) x = std::sqrt(x * x + y * y), y = 0.0;
    return deep_[static_cast<std::size_t>(cell(y * y_) * kAcross + cell(x * x_))];
  }

 private:
  static int cell(double repeats) {
    const double part = repeats - std::floor(repeats);
    return part >= 0.0 ? std::min(static_cast<int>(part * kAcross), kAcross - 1) : 0;  // not NaN
  }
  bool round_;
  double x_, y_;  // repeats a metre
  std::array<float, std::size_t{kAcross} * kAcross> deep_{};
};

// Numbers that a place on a pot can have.
bool usable(const Impression& left) {
  constexpr double kMost = 1e3;  // m, rad
  for (const double each : {left.low, left.high, left.from, left.to, left.angle, left.half,
                            left.wide, left.tall, left.deep, left.tilt})
    if (!(std::fabs(each) <= kMost)) return false;
  return true;
}

// One side of the wall: its rows of cells, from the one nearest to the foot up.
class Side {
 public:
  Side(const Surface& surface, bool inside) : surface_(surface), inside_(inside) {
    const Part part = inside ? Part::inside : Part::outside;
    for (int j = 0; j < surface.rows(); ++j)
      if (surface.row(j).part == part) rows_.push_back(j);
    if (inside) std::ranges::reverse(rows_);
    const std::size_t cells = rows_.size() * std::size_t{kSectors};
    bare_.assign(cells, 1.0f);
    deep_.assign(cells, 0.0f);
  }

  // What was left later is already there.
  void under(const Impression& left, const Pattern& pattern, double depth) {
    const double face_of = left.to - left.from, wall = left.high - left.low;
    if (left.inside != inside_ || !(wall > 0.0) || !(face_of > 0.0) || !(left.half > 0.0)) return;
    const int first = row_above(left.low), end = row_above(left.high);
    constexpr double kRowUp = kRowHeight * 1e-6;
    // Lengths along the wall are the face's, stretched as much as its clay.
    const double up = left.tall * face_of / wall * kRowUp;
    const double middle = left.low - left.from / face_of * wall;
    const double near = std::clamp(middle, left.low, left.high);
    const double level = row_above(near) + (middle - near) / kRowUp;
    const double centre = left.angle / (2.0 * kPi) * kSectors - 0.5;
    const double across = left.half / (2.0 * kPi) * kSectors;
    const auto from = static_cast<int>(std::ceil(centre - across));
    const auto to = std::min(static_cast<int>(std::floor(centre + across)), from + kSectors - 1);
    const double in = std::clamp(0.0, left.from, left.to);
    const double most = face(0.0, in);
    const double whole = most > 0.0 ? left.deep / (depth * most) : 0.0;
    const double c = portable::cos(left.tilt), s = portable::sin(left.tilt);
    for (int row = first; row < end; ++row) {
      const double v = left.from + (height(row) - left.low) / wall * face_of;
      const double y = (row - level) * up;
      for (int k = from; k <= to; ++k) {
        const auto cell = static_cast<std::size_t>(row * kSectors + wrapped(k));
        const float bare = bare_[cell];
        if (bare <= kCovered) continue;
        const double u = (k - centre) / across;
        const double covers =
            left.hand ? runs_out(v) * (left.half < kPi ? runs_out(u) : 1.0) : whole * face(u, v);
        if (!(covers > 0.0)) continue;
        const float takes = bare * static_cast<float>(std::min(covers, 1.0));
        const double x = u * left.wide;
        deep_[cell] += takes * pattern.at(c * x + s * y, c * y - s * x);
        bare_[cell] = bare - takes;
      }
    }
  }

  bool write(Surface& surface, double depth) const {
    bool any = false;
    for (std::size_t row = 0; row < rows_.size(); ++row)
      for (int i = 0; i < kSectors; ++i) {
        const double deep = double{deep_[row * kSectors + static_cast<std::size_t>(i)]};
        const auto um = static_cast<int>(1e6 * depth * deep + 0.5);
        if (um <= 0) continue;
        surface.set_relief(rows_[row], i, -std::min(um, surface.deepest(rows_[row])));
        any = true;
      }
    return any;
  }

 private:
  double height(int row) const { return surface_.row(rows_[static_cast<std::size_t>(row)]).height; }
  // The lowest row whose middle is at `height` or above.
  int row_above(double height) const {
    const auto row = std::ranges::lower_bound(rows_, height, {},
                                              [this](int j) { return surface_.row(j).height; });
    return static_cast<int>(row - rows_.begin());
  }
  static double face(double u, double v) {
    const double square = u * u + v * v;
    return square < 1.0 ? (1.0 - square) * (1.0 - square) : 0.0;
  }
  static double runs_out(double t) { return std::clamp((1.0 - std::fabs(t)) / kEdge, 0.0, 1.0); }

  const Surface& surface_;
  bool inside_;
  std::vector<int> rows_;
  std::vector<float> bare_, deep_;  // by cell: share that nothing lies on yet, and depth, 0..1
};

}  // namespace

bool imprint(Surface& surface, std::span<const Impression> left, const ImprintDef& def) {
  const std::array<Pattern, 4> patterns{
      Pattern(Impression::even, def), Pattern(Impression::cord, def),
      Pattern(Impression::grid, def), Pattern(Impression::rings, def)};
  bool any = false;
  for (const bool inside : {false, true}) {
    if (std::ranges::none_of(left, [&](const Impression& each) {
          return each.inside == inside && each.face != Impression::even;
        }))
      continue;
    Side side(surface, inside);
    for (std::size_t n = left.size(); n-- > 0;)
      if (usable(left[n]))
        side.under(left[n], patterns[static_cast<std::size_t>(left[n].face)], def.depth);
    any = side.write(surface, def.depth) || any;
  }
  return any;
}

}  // namespace onggi::surface
