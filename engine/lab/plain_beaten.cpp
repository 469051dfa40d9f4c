#include "engine/lab/plain_beaten.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/math/portable.h"

namespace onggi::lab {
namespace {

constexpr double kRoundWall = 2.0 * portable::kPi;

// Half the sum of outer^2 - inner^2 over a row.
double cut_of(const double* outer, const double* inner, int sectors) {
  double sum = 0.0;
  for (int i = 0; i < sectors; ++i) sum += (outer[i] - inner[i]) * (outer[i] + inner[i]);
  return 0.5 * sum;
}

// Solves the three equations by elimination; the matrix is symmetric and positive.
std::array<double, 3> solved(std::array<std::array<double, 4>, 3> m) {
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = k + 1; j < 3; ++j)
      for (std::size_t i = 4; i-- > k;) m[j][i] -= m[k][i] * m[j][k] / m[k][k];
  std::array<double, 3> x{};
  for (std::size_t k = 3; k-- > 0;) {
    x[k] = m[k][3];
    for (std::size_t i = k + 1; i < 3; ++i) x[k] -= m[k][i] * x[i];
    x[k] /= m[k][k];
  }
  return x;
}

}  // namespace

std::vector<double> out_of_plane(std::span<const PlainPlace> all) {
  std::array<std::array<double, 4>, 3> sums{};
  for (const PlainPlace& one : all) {
    const std::array<double, 4> terms{1.0, one.round, one.up, one.value};
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 4; ++i) sums[j][i] += one.weight * terms[j] * terms[i];
  }
  const auto [mean, by_round, by_up] = solved(sums);
  std::vector<double> proud;
  for (const PlainPlace& one : all)
    proud.push_back(one.value - mean - by_round * one.round - by_up * one.up);
  return proud;
}

PlainBeaten::PlainBeaten(const ClayDef& clay, const BeatingDef& law)
    : law_(law), rows_(clay.rows), sectors_(clay.sectors) {
  const auto rows = static_cast<std::size_t>(rows_);
  outer_.assign(rows * static_cast<std::size_t>(sectors_), clay.outer_radius);
  inner_.assign(outer_.size(), clay.inner_radius);
  thick_.assign(rows, clay.height / rows_);
  height_.assign(rows, 0.0);
  const double cut = cut_of(outer_.data(), inner_.data(), sectors_);
  volume_.assign(rows, cut * thick_.front());
  stack();
}

// Each row keeps its clay, and stands on the one below.
void PlainBeaten::stack() {
  double up = 0.0;
  for (std::size_t j = 0; j < height_.size(); ++j) {
    const std::size_t at = j * static_cast<std::size_t>(sectors_);
    thick_[j] = volume_[j] / cut_of(&outer_[at], &inner_[at], sectors_);
    height_[j] = up + 0.5 * thick_[j];
    up += thick_[j];
  }
}

double PlainBeaten::radius_at(const PlainBlow& blow) const {
  const auto row = std::ranges::lower_bound(height_, blow.height) - height_.begin();
  const double whole = std::floor(blow.angle / kRoundWall * sectors_);
  const auto sector = static_cast<std::size_t>(whole - sectors_ * std::floor(whole / sectors_));
  return outer_[static_cast<std::size_t>(row) * static_cast<std::size_t>(sectors_) + sector];
}

std::vector<PlainBeaten::Under> PlainBeaten::under(const PlainBlow& blow) const {
  std::vector<Under> all;
  const auto sectors = static_cast<std::size_t>(sectors_);
  const double radius = radius_at(blow);
  const double face = std::min(law_.face, radius);
  for (int j = 0; j < rows_; ++j) {
    const double up = (height_[static_cast<std::size_t>(j)] - blow.height) / law_.face;
    if (std::fabs(up) >= 1.0) continue;
    for (std::size_t i = 0; i < sectors; ++i) {
      const double turn = (static_cast<double>(i) + 0.5) * kRoundWall / sectors_ - blow.angle;
      const double chord = 2.0 * radius * portable::sin(0.5 * turn) / face;
      const double square = up * up + chord * chord;
      if (square >= 1.0) continue;
      all.push_back({static_cast<std::size_t>(j) * sectors + i, j, (1.0 - square) * (1.0 - square),
                     radius * portable::sin(turn) / face, up,
                     radius * kRoundWall / sectors_ * thick_[static_cast<std::size_t>(j)]});
    }
  }
  return all;
}

// d of the sum of x + x^2 / t over the area, x = w (d + e) or 0.
double PlainBeaten::depth(std::span<const Under> all, double work,
                          std::span<const double> proud) const {
  constexpr int kDepthHalvings = 60;
  double low = -0.01, high = 0.01;  // m
  for (int n = 0; n < kDepthHalvings; ++n) {
    const double middle = 0.5 * (low + high);
    double sum = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double x = std::max(0.0, all[k].weight * (middle + proud[k]));
      sum += all[k].area * (x + x * x / (outer_[all[k].at] - inner_[all[k].at]));
    }
    (sum < work ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void PlainBeaten::strike(const PlainBlow& blow) {
  const std::vector<Under> all = under(blow);
  double area = 0.0, wall = 0.0;
  for (const Under& one : all) {
    area += one.weight * one.area;
    wall += one.weight * one.area * (outer_[one.at] - inner_[one.at]);
  }
  wall /= area;
  const auto rows = static_cast<std::size_t>(rows_);
  const double radius = radius_at(blow);
  const double face = std::sqrt(std::min(law_.face, radius) * law_.face);
  const double pressure = law_.yield_stress * (1.0 + 2.0 * face / (3.0 * std::sqrt(3.0) * wall));
  const double work = 0.5 * std::min(blow.swing, blow.anvil) * law_.energy / pressure;
  std::array<std::vector<double>, 2> into;
  for (const bool outside : {true, false}) {
    std::vector<PlainPlace> places;
    for (const Under& one : all)
      places.push_back(
          {one.weight * one.area, one.round, one.up, outside ? outer_[one.at] : -inner_[one.at]});
    const std::vector<double> proud = out_of_plane(places);
    const double deep = depth(all, work, proud);
    std::vector<double>& x = into[outside ? 0 : 1];
    for (std::size_t k = 0; k < all.size(); ++k)
      x.push_back(work > 0.0 ? std::max(0.0, all[k].weight * (deep + proud[k])) : 0.0);
  }
  const double moved =
      (blow.swing - blow.anvil) * law_.energy / (portable::kPi * law_.yield_stress * wall * wall);

  // By row: the mean of ln(before / after), and of the weight, over the ring.
  std::vector<double> thinner(rows, 0.0), weight(rows, 0.0);
  for (std::size_t k = 0; k < all.size(); ++k) {
    double &outer = outer_[all[k].at], &inner = inner_[all[k].at];
    const double before = outer - inner;
    outer -= into[0][k] + all[k].weight * moved;
    inner += into[1][k] - all[k].weight * moved;
    const auto j = static_cast<std::size_t>(all[k].row);
    thinner[j] += portable::log(before / (outer - inner)) / sectors_;
    weight[j] += all[k].weight / sectors_;
  }
  // The rings get wider together by half of that, each as far as it lies under the face.
  const double all_thinner = std::inner_product(thick_.begin(), thick_.end(), thinner.begin(), 0.0);
  const double all_weight = std::inner_product(thick_.begin(), thick_.end(), weight.begin(), 0.0);
  for (std::size_t j = 0; j < rows; ++j) {
    if (weight[j] == 0.0) continue;
    const double wider = 0.5 * all_thinner / all_weight * weight[j] * (radius - 0.5 * wall);
    for (std::size_t i = 0; i < static_cast<std::size_t>(sectors_); ++i) {
      outer_[j * static_cast<std::size_t>(sectors_) + i] += wider;
      inner_[j * static_cast<std::size_t>(sectors_) + i] += wider;
    }
  }
  stack();
}

double PlainBeaten::volume() const {
  double sum = 0.0;
  for (std::size_t j = 0; j < thick_.size(); ++j) {
    const std::size_t at = j * static_cast<std::size_t>(sectors_);
    sum += thick_[j] * cut_of(&outer_[at], &inner_[at], sectors_);
  }
  return sum * kRoundWall / sectors_;
}

double PlainBeaten::height() const { return height_.back() + 0.5 * thick_.back(); }

FaceGrid PlainBeaten::face(WallSide side, double low, double high, int heights) const {
  FaceGrid face{heights, sectors_, low, (high - low) / (heights - 1), 0.0, {}};
  const std::vector<double>& of = side == WallSide::outside ? outer_ : inner_;
  for (int k = 0; k < heights; ++k) {
    const double up = low + k * face.thickness;
    const auto above = std::clamp<std::ptrdiff_t>(
        std::ranges::upper_bound(height_, up) - height_.begin(), 1, rows_ - 1);
    const auto j = static_cast<std::size_t>(above);
    const double share = (up - height_[j - 1]) / (height_[j] - height_[j - 1]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(sectors_); ++i) {
      const double* const at = &of[j * static_cast<std::size_t>(sectors_) + i];
      face.radius.push_back(*(at - sectors_) + share * (*at - *(at - sectors_)));
    }
  }
  return face;
}

}  // namespace onggi::lab
