#include "kiosk/exhibit/composition/rollout_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace onggi::exhibit {

namespace {

constexpr double kWholeTurn = 2.0 * std::numbers::pi;
constexpr int kSamples = 2;  // of a pixel, across and down
constexpr double kHardlyWidens =
    0.015;  // a cone whose development would be over 60 times as far off

using Rgb = std::array<double, 3>;

/// Of the strip, `turn` of the way from its left and `up` from its foot; both 0..1.
Rgb strip_at(const view::Image& strip, double turn, double up) {
  const double x = (turn - std::floor(turn)) * strip.width - 0.5;
  const double y = std::clamp((1.0 - up) * strip.height - 0.5, 0.0, strip.height - 1.0);
  const double left = std::floor(x);
  const auto column = [&](double at) {
    const auto whole = static_cast<int>(at) % strip.width;
    return static_cast<std::size_t>(whole < 0 ? whole + strip.width : whole);
  };
  const auto low = static_cast<std::size_t>(y);
  const std::size_t high = std::min(low + 1, static_cast<std::size_t>(strip.height - 1));
  const auto value = [&](std::size_t row, std::size_t across, std::size_t k) {
    return double{strip.rgba[4 * (row * static_cast<std::size_t>(strip.width) + across) + k] + 0.0};
  };
  Rgb out{};
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = std::lerp(
        std::lerp(value(low, column(left), k), value(low, column(left + 1), k), x - left),
        std::lerp(value(high, column(left), k), value(high, column(left + 1), k), x - left),
        y - static_cast<double>(low));
  return out;
}

/// Draws each pixel as the mean of its samples; `at`: the colour at a place in pixels, or nothing.
template <class At>
view::Image sampled(int width, int height, const At& at) {
  view::Image out{width, height, {}};
  out.rgba.reserve(4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Rgb sum{};
      int met = 0;
      for (int n = 0; n < kSamples * kSamples; ++n) {
        const std::optional<Rgb> here =
            at(x + (n % kSamples + 0.5) / kSamples, y + (n / kSamples + 0.5) / kSamples);
        if (!here) continue;
        ++met;
        for (std::size_t k = 0; k < 3; ++k) sum[k] += (*here)[k];
      }
      for (const double part : sum)
        out.rgba.push_back(static_cast<std::uint8_t>(
            std::lround(std::clamp(met > 0 ? part / met : 0.0, 0.0, 255.0))));
      out.rgba.push_back(static_cast<std::uint8_t>(255 * met / (kSamples * kSamples)));
    }
  return out;
}

/// A zone laid flat.
class Development {
 public:
  Development(std::span<const Vec2> outline, const Cone& cone) : cone_(cone) {
    widens_ = std::abs(cone.along.x);
    flat_ = widens_ < kHardlyWidens;
    double last = -1e9;
    for (std::size_t n = cone.first; n <= cone.last; ++n) {
      // The outline may turn back on itself by a little.
      last = std::max(last + 1e-9, dot(outline[n] - cone.at, cone.along));
      ways_.push_back(last);
      ups_.push_back(static_cast<double>(n) / static_cast<double>(outline.size() - 1));
    }
    mean_ = cone.at.x;
    for (int n = 0; n <= 64; ++n)
      for (const double way : {ways_.front(), ways_.back()}) {
        const Vec2 at = place(n / 64.0 - 0.5, way);
        low_ = {std::min(low_.x, at.x), std::min(low_.y, at.y)};
        high_ = {std::max(high_.x, at.x), std::max(high_.y, at.y)};
      }
  }
  Vec2 low() const { return low_; }
  Vec2 high() const { return high_; }

  /// Turn and height on the strip of a place; nothing beside the zone.
  std::optional<std::array<double, 2>> strip_of(Vec2 at) const {
    double turn = 0.0, way = 0.0;
    if (flat_) {
      turn = at.x / (kWholeTurn * mean_);
      way = at.y;
    } else {
      const double side = cone_.along.x > 0.0 ? 1.0 : -1.0;
      turn = std::atan2(at.x, side * at.y) / (kWholeTurn * widens_);
      way = (length(at) * widens_ - cone_.at.x) / cone_.along.x;
    }
    if (std::abs(turn) > 0.5 || way < ways_.front() || way > ways_.back()) return {};
    const auto after = std::ranges::upper_bound(ways_, way);
    const auto n = std::min(static_cast<std::size_t>(after - ways_.begin()), ways_.size() - 1);
    const double part = (way - ways_[n - 1]) / (ways_[n] - ways_[n - 1]);
    return std::array{turn + 0.5, std::lerp(ups_[n - 1], ups_[n], part)};
  }

 private:
  Vec2 place(double turn, double way) const {
    if (flat_) return {turn * kWholeTurn * mean_, way};
    const double far = std::max(cone_.at.x + cone_.along.x * way, 0.0) / widens_;
    const double angle = turn * kWholeTurn * widens_;
    const double side = cone_.along.x > 0.0 ? 1.0 : -1.0;
    return {far * std::sin(angle), side * far * std::cos(angle)};
  }

  Cone cone_;
  double widens_ = 0.0, mean_ = 0.0;
  bool flat_ = false;
  std::vector<double> ways_, ups_;  // along the cone, m; and on the strip, 0..1
  Vec2 low_{1e9, 1e9}, high_{-1e9, -1e9};
};

}  // namespace

view::Image side_view(const view::Image& strip, std::span<const Vec2> outline, double rim,
                      double pixels) {
  double widest = 0.0, tallest = rim;
  for (const Vec2 at : outline) widest = std::max(widest, at.x), tallest = std::max(tallest, at.y);
  const int width = std::max(2, 2 * static_cast<int>(std::ceil(widest * pixels)));
  const int height = std::max(1, static_cast<int>(std::ceil(tallest * pixels)));
  return sampled(width, height, [&](double px, double py) -> std::optional<Rgb> {
    const double x = (px - 0.5 * width) / pixels;
    const double y = std::min((height - py) / pixels, outline.back().y);
    // The uppermost piece there: a shoulder may come back down.
    for (std::size_t n = outline.size() - 1; n > 0; --n) {
      const Vec2 a = outline[n - 1], b = outline[n];
      if (y < std::min(a.y, b.y) || y > std::max(a.y, b.y)) continue;
      const double part = b.y != a.y ? (y - a.y) / (b.y - a.y) : 0.0;
      const double r = std::lerp(a.x, b.x, part);
      if (std::abs(x) > r) continue;
      const double angle = std::asin(std::clamp(x / std::max(r, 1e-9), -1.0, 1.0));
      const double up =
          (static_cast<double>(n) - 1.0 + part) / static_cast<double>(outline.size() - 1);
      Rgb color = strip_at(strip, 0.5 + angle / kWholeTurn, up);
      const double way = length(b - a);
      const Vec2 out = way > 0.0 ? Vec2{(b.y - a.y) / way, -(b.x - a.x) / way} : Vec2{1.0, 0.0};
      const double faces =
          -0.45 * std::sin(angle) * out.x + 0.45 * out.y + 0.77 * std::cos(angle) * out.x;
      const double light = 0.55 + 0.5 * std::max(faces, 0.0);
      for (double& part_ : color) part_ *= light;
      return color;
    }
    return {};
  });
}

view::Image on_cones(const view::Image& strip, std::span<const Vec2> outline,
                     std::span<const Cone> cones, double pixels, double gap) {
  std::vector<Development> zones;
  std::vector<double> floors;  // of each zone in the picture, m from its foot
  double wide = 0.0, tall = 0.0;
  for (const Cone& cone : cones) {
    zones.emplace_back(outline, cone);
    const Development& zone = zones.back();
    if (zones.size() > 1) tall += gap;
    floors.push_back(tall);
    tall += zone.high().y - zone.low().y;
    wide = std::max(wide, zone.high().x - zone.low().x);
  }
  const int width = std::max(1, static_cast<int>(std::ceil(wide * pixels)));
  const int height = std::max(1, static_cast<int>(std::ceil(tall * pixels)));
  return sampled(width, height, [&](double px, double py) -> std::optional<Rgb> {
    const double x = (px - 0.5 * width) / pixels, y = (height - py) / pixels;
    for (std::size_t n = zones.size(); n-- > 0;) {
      if (y < floors[n]) continue;
      const Development& zone = zones[n];
      const auto at =
          zone.strip_of({x + 0.5 * (zone.low().x + zone.high().x), y - floors[n] + zone.low().y});
      return at ? std::optional(strip_at(strip, (*at)[0], (*at)[1])) : std::nullopt;
    }
    return {};
  });
}

}  // namespace onggi::exhibit
