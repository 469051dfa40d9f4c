#include "kiosk/exhibit/composition/unrolled_pot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/clay/lip.h"
#include "engine/surface/outline_rows.h"
#include "kiosk/collection/content/coloring.h"

namespace onggi::exhibit {

namespace {

constexpr double kHalfTurn = std::numbers::pi;

/// Way over the round lip from a face to `x` inside it, m (way_over in coat.glsl).
double way_over(double x, double edge) {
  return x < edge ? edge * std::acos(std::clamp(1.0 - x / edge, 0.0, 1.0))
                  : (0.5 * kHalfTurn - 1.0) * edge + x;
}

/// The inverse.
double x_of(double way, double edge) {
  return way < 0.5 * kHalfTurn * edge ? edge * (1.0 - std::cos(way / edge))
                                      : way - (0.5 * kHalfTurn - 1.0) * edge;
}

}  // namespace

UnrolledPot::UnrolledPot(const Profile& made, const decoration::CoatPicture& coat)
    : made_(made), by_height_(coat.rows_by_height()), floor_from_(double{coat.floor_from()}) {
  rim_ = made.height();
  const double wall = made.outer_at(rim_) - made.inner_at(rim_);
  shoulder_ = rim_ - std::min(0.5 * wall, kLipRadius);
  out_ = made.outer_at(shoulder_);
  in_ = std::min(made.inner_at(shoulder_), out_);
  lip_from_ = row_on(0, shoulder_);
  lip_to_ = row_on(1, shoulder_);
  // Of the surface's rows, 1,680 are as long as it is round.
  const double even = 1.0 * coat.height() * kWidth / coat.width();
  const int high = even > 0.7 * kWidth ? kWidth : kWidth / 2;
  picture_ = {kWidth, high, {}};
  picture_.rgba.reserve(4u * kWidth * static_cast<std::size_t>(high));
  outline_ = lip_from_ * coat.height() * 1e-6 * surface::kRowHeight;
}

double UnrolledPot::row_on(std::size_t wall, double height) const {
  const auto last = by_height_.size() - 1;
  const double at = std::clamp(height / rim_, 0.0, 1.0) * static_cast<double>(last);
  const std::size_t k = std::min(static_cast<std::size_t>(at), last - 1);
  return std::lerp(double{by_height_[k][wall]}, double{by_height_[k + 1][wall]},
                   at - static_cast<double>(k));
}

// Rows rise with the height outside and fall inside.
double UnrolledPot::height_on(std::size_t wall, double row) const {
  double low = 0, high = rim_;
  for (int n = 0; n < 40; ++n) {
    const double middle = 0.5 * (low + high);
    ((row_on(wall, middle) < row) == (wall == 0) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

UnrolledPot::Spot UnrolledPot::spot_at(double row) const {
  if (row < lip_from_) {
    const double height = height_on(0, row);
    return {height, made_.outer_at(height), ClayFace::outer};
  }
  if (row < lip_to_) {
    const double wall = out_ - in_, edge = lip_edge();
    const double half = way_over(0.5 * wall, edge);
    const double way = 2.0 * half * (row - lip_from_) / (lip_to_ - lip_from_);
    const double x = way < half ? x_of(way, edge) : wall - x_of(2.0 * half - way, edge);
    return {rim_ - lip_drop(in_, out_, out_ - x), out_ - x, ClayFace::rim};
  }
  if (row < floor_from_) {
    const double height = std::max(height_on(1, row), made_.floor_height());
    return {height, made_.inner_at(height), ClayFace::inner};
  }
  const double floor = made_.floor_height(), wall = made_.inner_at(floor);
  const double share = (row - floor_from_) / std::max(1.0 - floor_from_, 1e-6);
  return {floor, std::lerp(wall, std::min(surface::kLeastRadius, wall), share), ClayFace::floor};
}

ClayMesh UnrolledPot::next_places() const {
  ClayMesh places;
  const int to = std::min(row_ + kStrip, picture_.height);
  for (int row = row_; row < to; ++row) {
    const Spot spot = spot_at((row + 0.5) / picture_.height);
    for (int column = 0; column < kWidth; ++column) {
      const double angle = 2.0 * kHalfTurn * (column + 0.5) / kWidth;
      places.mesh.positions.push_back({static_cast<float>(spot.radius * std::cos(angle)),
                                       static_cast<float>(spot.height),
                                       static_cast<float>(spot.radius * std::sin(angle))});
      places.faces.push_back(spot.face);
    }
  }
  return places;
}

void UnrolledPot::take(const std::vector<view::SkinPoint>& skin) {
  for (const view::SkinPoint& point : skin) {
    for (const float light : point.color) picture_.rgba.push_back(content::display_of(light));
    picture_.rgba.push_back(255);
    rough_.push_back(static_cast<std::uint8_t>(std::lround(255.0f * point.roughness)));
  }
  row_ += static_cast<int>(skin.size()) / kWidth;
}

std::vector<Vec2> UnrolledPot::outline() const {
  std::vector<Vec2> out;
  for (const ProfilePoint& point : made_.points)
    if (point.height < shoulder_) out.push_back({point.outer, point.height});
  out.push_back({out_, shoulder_});
  return out;
}

view::Image UnrolledPot::roughness() const {
  view::Image out{kWidth / 2, picture_.height / 2, {}};
  out.rgba.reserve(4u * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const auto at = static_cast<std::size_t>(2 * y) * kWidth + static_cast<std::size_t>(2 * x);
      const int sum = rough_[at] + rough_[at + 1] + rough_[at + kWidth] + rough_[at + kWidth + 1];
      const auto grey = static_cast<std::uint8_t>((sum + 2) / 4);
      out.rgba.insert(out.rgba.end(), {grey, grey, grey, 255});
    }
  return out;
}

double UnrolledPot::lip_edge() const {
  return std::max(std::min(0.5 * (out_ - in_), kLipRadius), 1e-6);
}

double UnrolledPot::row_of(double rho, double height, ClayFace face) const {
  switch (face) {
    case ClayFace::foot:
      return 0.0;
    case ClayFace::outer:
      return std::min(row_on(0, height), lip_from_);
    case ClayFace::rim: {
      const double wall = out_ - in_, x = std::clamp(out_ - rho, 0.0, wall);
      const double half = way_over(0.5 * wall, lip_edge());
      const double way =
          x < 0.5 * wall ? way_over(x, lip_edge()) : 2.0 * half - way_over(wall - x, lip_edge());
      return std::lerp(lip_from_, lip_to_, 0.5 * way / half);
    }
    case ClayFace::inner:
      return std::clamp(row_on(1, height), lip_to_, floor_from_);
    case ClayFace::floor:
      break;
  }
  const double wall = made_.inner_at(made_.floor_height());
  const double way = (wall - rho) / std::max(wall - surface::kLeastRadius, 1e-4);
  return std::lerp(floor_from_, 1.0, std::clamp(way, 0.0, 1.0));
}

std::vector<std::array<float, 2>> UnrolledPot::places_of(const ClayMesh& pot) const {
  std::vector<std::array<float, 2>> places;
  const auto rho_of = [&](std::size_t n) {
    return std::hypot(double{pot.mesh.positions[n][0]}, double{pot.mesh.positions[n][2]});
  };
  for (std::size_t n = 0; n < pot.faces.size(); ++n) {
    const auto& [x, y, z] = pot.mesh.positions[n];
    const double turns = std::atan2(double{z}, double{x}) / (2.0 * kHalfTurn);
    places.push_back({static_cast<float>(turns < 0.0 ? turns + 1.0 : turns),
                      static_cast<float>(row_of(rho_of(n), double{y}, pot.faces[n]))});
  }
  // On the axis a corner has its triangle's angle: each has its own corner there.
  for (const auto& triangle : pot.mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (rho_of(triangle[k]) == 0.0) places[triangle[k]][0] = places[triangle[(k + 1) % 3]][0];
  return places;
}

view::Image UnrolledPot::rollout() const {
  double widest = 0;
  for (const ProfilePoint& point : made_.points) widest = std::max(widest, point.outer);
  const double round = 2.0 * kHalfTurn * widest;
  view::Image out{
      kWidth, std::max(1, static_cast<int>(std::lround(kWidth * outline_ / round))), {}};
  out.rgba.resize(4u * kWidth * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y) {
    // The foot is below.
    const double row = lip_from_ * (1.0 - (y + 0.5) / out.height);
    const double at = std::max(row * picture_.height - 0.5, 0.0);
    const auto low = static_cast<std::size_t>(at);
    const std::size_t high = std::min(low + 1, static_cast<std::size_t>(picture_.height - 1));
    const double part = at - static_cast<double>(low);
    for (int x = 0; x < kWidth; ++x) {
      // Seen from outside, angles grow to the left.
      const auto column = static_cast<std::size_t>(kWidth - 1 - x);
      for (std::size_t k = 0; k < 4; ++k)
        out.rgba[4 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)) + k] =
            static_cast<std::uint8_t>(std::lround(
                std::lerp(double(picture_.rgba[4 * (low * kWidth + column) + k]),
                          double(picture_.rgba[4 * (high * kWidth + column) + k]), part)));
    }
  }
  return out;
}

}  // namespace onggi::exhibit
