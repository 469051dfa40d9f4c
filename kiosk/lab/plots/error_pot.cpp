#include "kiosk/lab/plots/error_pot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kiosk/picture/view/palette.h"

namespace onggi::plots {
namespace {

constexpr double kHalfTurn = 3.14159265358979324;
constexpr double kLeast = 1e-6, kDecades = 3.0;  // m; up to a millimetre
constexpr int kSamples = 2;                      // samples a pixel in each direction

constexpr std::array<view::Color, 5> kTones{view::rgb(0x2E6B57), view::rgb(0x9DB5A0),
                                            view::rgb(0xF1E4C8), view::rgb(0xD98B4A),
                                            view::rgb(0x8A1C10)};

class Turned {
 public:
  explicit Turned(const PotFace& pot) : pot_(pot) {}
  // At a share of the height and an angle from the left, 0..pi.
  double radius(double up, double angle) const { return at(pot_.radius, up, angle); }
  double off(double up, double angle) const { return at(pot_.off, up, angle); }

 private:
  double at(const std::vector<float>& of, double up, double angle) const {
    const double j = std::clamp(up, 0.0, 1.0) * (pot_.rows - 1);
    const double i = std::clamp(angle / kHalfTurn * pot_.columns - 0.5, 0.0, pot_.columns - 1.0);
    const int row = std::min(static_cast<int>(j), pot_.rows - 2);
    const int column = std::min(static_cast<int>(i), pot_.columns - 2);
    const auto value = [&](int r, int c) {
      return double{of[static_cast<std::size_t>(r) * static_cast<std::size_t>(pot_.columns) +
                       static_cast<std::size_t>(c)]};
    };
    const double a = i - column, b = j - row;
    return (1 - b) * ((1 - a) * value(row, column) + a * value(row, column + 1)) +
           b * ((1 - a) * value(row + 1, column) + a * value(row + 1, column + 1));
  }
  const PotFace& pot_;
};

struct PotSample {
  double r = 0, g = 0, b = 0, a = 0;
};

// The visible place at `x` (m right of the axis) and `up` (share of the height): the ray goes along
// z.
PotSample seen_on(const PotFace& pot, const Turned& turned, double x, double up) {
  double angle = 0.5 * kHalfTurn, radius = 0.0;
  // The surface is nearly round: a few rounds of x = -r cos(angle) find it.
  for (int n = 0; n < 6; ++n) {
    radius = turned.radius(up, angle);
    if (std::fabs(x) >= radius) return {};
    angle = std::acos(std::clamp(-x / radius, -1.0, 1.0));
  }
  const double step = 1.5 / pot.rows;
  const double slope = (turned.radius(up + step, angle) - turned.radius(up - step, angle)) /
                       (2.0 * step * pot.height);
  const double length = std::sqrt(1.0 + slope * slope);
  const double nx = -std::cos(angle) / length, ny = -slope / length, nz = std::sin(angle) / length;
  const double light = std::max(0.0, -0.52 * nx + 0.50 * ny + 0.69 * nz);
  const double shade = 0.42 + 0.68 * light;
  const view::Color tone = tone_of_error(turned.off(up, angle));
  const auto lit = [&](float v) -> double { return std::min(1.0, shade * double{v}); };
  return {lit(tone.r), lit(tone.g), lit(tone.b), 1.0};
}

}  // namespace

double share_of_error(double off) {
  return std::clamp(std::log10(std::max(off, kLeast) / kLeast) / kDecades, 0.0, 1.0);
}
double error_from_share(double share) { return kLeast * std::pow(10.0, share * kDecades); }

view::Color tone_of_error(double off) {
  const double at = share_of_error(off) * (kTones.size() - 1);
  const auto n = std::min(static_cast<std::size_t>(at), kTones.size() - 2);
  const auto share = static_cast<float>(at - static_cast<double>(n));
  const view::Color a = kTones[n], b = kTones[n + 1];
  return {a.r + share * (b.r - a.r), a.g + share * (b.g - a.g), a.b + share * (b.b - a.b), 1.0f};
}

view::Image paint_pot(const PotFace& pot, int pixels) {
  const Turned turned(pot);
  const double widest = double{*std::ranges::max_element(pot.radius)};
  const double per_metre = pixels / pot.height;
  view::Image image;
  image.height = pixels;
  image.width = 2 * (static_cast<int>(widest * per_metre) + 2);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      PotSample sum;
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const double x = column + (k % kSamples + 0.5) / kSamples - 0.5 * image.width;
        const double y = row + (k / kSamples + 0.5) / kSamples;
        const PotSample one = seen_on(pot, turned, x / per_metre, 1.0 - y / image.height);
        sum = {sum.r + one.r, sum.g + one.g, sum.b + one.b, sum.a + one.a};
      }
      const double all = std::max(sum.a, 1e-9);
      for (const double part :
           {sum.r / all, sum.g / all, sum.b / all, sum.a / (kSamples * kSamples)})
        image.rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0 * part)));
    }
  return image;
}

}  // namespace onggi::plots
