#include "kiosk/loop/mirror.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace onggi::loop {

namespace {
double mean(const float* first, int n) {
  return std::accumulate(first, first + n, 0.0) / static_cast<double>(n);
}
}  // namespace

void Mirror::reset(int rows, int sectors, double height, double floor_height, double outer,
                   double inner) {
  rows_ = rows;
  sectors_ = sectors;
  height_ = height;
  floor_height_ = floor_height;
  const auto n = static_cast<std::size_t>(rows) * static_cast<std::size_t>(sectors);
  outer_.assign(n, static_cast<float>(outer));
  inner_.assign(n, static_cast<float>(inner));
  mean_outer_.assign(static_cast<std::size_t>(rows), outer);
  mean_inner_.assign(static_cast<std::size_t>(rows), inner);
  const double thickness = height / rows;
  for (int j = 0; j < rows && (j + 0.5) * thickness < floor_height; ++j) {
    const auto at = static_cast<std::size_t>(j) * static_cast<std::size_t>(sectors);
    std::fill_n(inner_.begin() + static_cast<std::ptrdiff_t>(at), sectors, 0.0f);
    mean_inner_[static_cast<std::size_t>(j)] = 0.0;
  }
}

void Mirror::apply(int row, const std::vector<float>& radii) {
  const auto sectors = static_cast<std::size_t>(sectors_);
  if (row < 0 || row >= rows_ || radii.size() != 2 * sectors) return;
  const auto r = static_cast<std::size_t>(row);
  std::copy_n(radii.begin(), sectors, outer_.begin() + static_cast<std::ptrdiff_t>(r * sectors));
  std::copy_n(radii.begin() + sectors_, sectors,
              inner_.begin() + static_cast<std::ptrdiff_t>(r * sectors));
  mean_outer_[r] = mean(radii.data(), sectors_);
  mean_inner_[r] = mean(radii.data() + sectors_, sectors_);
}

Profile Mirror::profile() const {
  Profile profile;
  if (rows_ == 0) return profile;
  profile.points.reserve(static_cast<std::size_t>(rows_) + 2);
  const double thickness = height_ / rows_;
  // Rows carry their middle; the foot and the rim repeat the row next to them.
  profile.points.push_back({0.0, mean_outer_.front(), mean_inner_.front()});
  for (int j = 0; j < rows_; ++j) {
    const auto r = static_cast<std::size_t>(j);
    profile.points.push_back({(j + 0.5) * thickness, mean_outer_[r], mean_inner_[r]});
  }
  profile.points.push_back({height_, mean_outer_.back(), mean_inner_.back()});
  return profile;
}

double Mirror::radius_at(double h, WallSide side) const {
  if (rows_ == 0) return 0.0;
  const std::vector<double>& means = side == WallSide::outside ? mean_outer_ : mean_inner_;
  const double at = std::clamp(h / height_ * rows_ - 0.5, 0.0, static_cast<double>(rows_ - 1));
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, means.size() - 1);
  const double share = at - static_cast<double>(below);
  return means[below] * (1 - share) + means[above] * share;
}

}  // namespace onggi::loop
