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
  wet_.clear();
  torn_.assign(static_cast<std::size_t>(rows), false);
  sectors_ = sectors;
  height_ = height;
  floor_height_ = floor_height;
  const auto n = static_cast<std::size_t>(rows) * static_cast<std::size_t>(sectors);
  outer_.assign(n, static_cast<float>(outer));
  inner_.assign(n, static_cast<float>(inner));
  mean_outer_.assign(static_cast<std::size_t>(rows), outer);
  mean_inner_.assign(static_cast<std::size_t>(rows), inner);
  middle_.resize(static_cast<std::size_t>(rows));
  for (int j = 0; j < rows; ++j) middle_[static_cast<std::size_t>(j)] = (j + 0.5) * height / rows;
  for (int j = 0; j < rows && middle_[static_cast<std::size_t>(j)] < floor_height; ++j) {
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

void Mirror::stack(int row, double middle, double rim, double floor) {
  if (row < 0 || row >= rows_) return;
  middle_[static_cast<std::size_t>(row)] = middle;
  height_ = rim;
  floor_height_ = floor;
}

void Mirror::tear(int row, bool torn) {
  if (row >= 0 && row < rows_) torn_[static_cast<std::size_t>(row)] = torn;
}

std::optional<double> Mirror::torn_wall() const {
  std::optional<double> thinnest;
  const auto sectors = static_cast<std::size_t>(sectors_);
  for (std::size_t r = 0; r < torn_.size(); ++r) {
    if (!torn_[r]) continue;
    for (std::size_t at = r * sectors; at < (r + 1) * sectors; ++at) {
      const double wall = double{outer_[at]} - double{inner_[at]};
      if (!thinnest || wall < *thinnest) thinnest = wall;
    }
  }
  return thinnest;
}

Profile Mirror::profile() const {
  Profile profile;
  if (rows_ == 0) return profile;
  profile.points.reserve(static_cast<std::size_t>(rows_) + 2);
  // Rows carry their middle; the foot and the rim repeat the row next to them.
  profile.points.push_back({0.0, mean_outer_.front(), mean_inner_.front()});
  for (std::size_t r = 0; r < middle_.size(); ++r) {
    // While rows are on their way some lie where others were: heights must rise all the same.
    if (middle_[r] > profile.height() && middle_[r] < height_)
      profile.points.push_back({middle_[r], mean_outer_[r], mean_inner_[r]});
  }
  profile.points.push_back({height_, mean_outer_.back(), mean_inner_.back()});
  return profile;
}

double Mirror::radius_at(double h, WallSide side) const {
  if (rows_ == 0) return 0.0;
  const std::vector<double>& means = side == WallSide::outside ? mean_outer_ : mean_inner_;
  const auto next = std::upper_bound(middle_.begin(), middle_.end(), h);
  if (next == middle_.begin()) return means.front();
  if (next == middle_.end()) return means.back();
  const auto above = static_cast<std::size_t>(next - middle_.begin());
  const std::size_t below = above - 1;
  const double gap = middle_[above] - middle_[below];
  const double share = gap > 0 ? std::clamp((h - middle_[below]) / gap, 0.0, 1.0) : 0.0;
  return means[below] * (1 - share) + means[above] * share;
}

}  // namespace onggi::loop
