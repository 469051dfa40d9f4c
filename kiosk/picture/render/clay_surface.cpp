#include "kiosk/picture/render/clay_surface.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace onggi::render {
namespace {

constexpr double kHalfTurn = 3.14159265358979, kLean = 0.35, kOutOfRound = 0.05;
constexpr float kWiden = 1.25f;  // margin, so that spreading clay is not uploaded again every frame

}  // namespace

void ClaySurface::make_room(const ClayView& clay) {
  all_rows_ = clay.room();
  all_sectors_ = clay.sectors();
  row_step_ = std::max(1, (all_rows_ + kMost - 1) / kMost);
  sector_step_ = std::max(1, (all_sectors_ + kMost - 1) / kMost);
  all_drawn_ = all_rows_ / row_step_;
  rows_ = clay.rows() / row_step_;
  sectors_ = all_sectors_ / sector_step_;
  if (empty()) return;
  for (auto* each : {&mean_outer_, &mean_inner_, &middle_})
    each->assign(static_cast<std::size_t>(all_drawn_), 0.0f);
  row_.resize(static_cast<std::size_t>(sectors_));
  widest_ = 0;
  tears_.reset(all_drawn_, row_step_);
  for (Radii* radii : {&outer_, &inner_}) {
    radii->steps.assign(row_.size() * static_cast<std::size_t>(all_drawn_), 0);
    radii->from = radii->to = 0;
    radii->texture = embedded() ? Texture::create(GL_R16UI, sectors_, all_drawn_, GL_RED_INTEGER,
                                                  GL_UNSIGNED_SHORT, radii->steps.data())
                                : Texture::create(GL_R16, sectors_, all_drawn_, GL_RED,
                                                  GL_UNSIGNED_SHORT, radii->steps.data());
    // Radii wrap around the axis and end at foot and rim.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  }
}

void ClaySurface::show(const ClayView& clay) {
  if (clay.room() != all_rows_ || clay.sectors() != all_sectors_) make_room(clay);
  seen_ = 0;
  update(clay);
}

// Removed rows are no longer torn.
void ClaySurface::use_rows(int rows) {
  for (int row = rows; row < all_rows_; ++row) tears_.note(row, false);
  const int drawn = rows / row_step_;
  if (drawn != rows_) stacked_ = false;
  rows_ = drawn;
}

float ClaySurface::top_row() const {
  return (static_cast<float>(rows_) - 0.5f) / static_cast<float>(all_drawn_);
}

void ClaySurface::update(const ClayView& clay) {
  if (clay.room() != all_rows_ || clay.sectors() != all_sectors_) return show(clay);
  if (empty() || clay.change() == seen_) return;
  make_wide(clay);
  if (height_ != clay.rim_height()) stacked_ = false;
  height_ = clay.rim_height();
  floor_top_ = clay.floor_top();
  use_rows(clay.rows());
  for (int row = 0; row < clay.rows(); ++row) {
    if (clay.placed_at(row) > seen_) tears_.note(row, clay.torn(row));
    if (row % row_step_ != 0 || row / row_step_ >= rows_) continue;
    const int j = row / row_step_;
    if (clay.shaped_at(row) > seen_) take_row(j, clay, row);
    float& middle = middle_[static_cast<std::size_t>(j)];
    const auto now = static_cast<float>(clay.row_height(row));
    if (middle != now) stacked_ = false;
    middle = now;
  }
  for (Radii* radii : {&outer_, &inner_}) send(*radii);
  seen_ = clay.change();
  changed_ = true;
}

void ClaySurface::make_wide(const ClayView& clay) {
  float widest = 0;
  for (int row = 0; row < clay.rows(); ++row)
    for (const float r : clay.outer(row)) widest = std::max(widest, r);
  if (widest <= widest_) return;
  widest_ = kWiden * widest;
  seen_ = 0;
}

void ClaySurface::take_row(int j, const ClayView& clay, int row) {
  take_radii(outer_, j, clay.outer(row));
  take_radii(inner_, j, clay.inner(row));
  mean_outer_[static_cast<std::size_t>(j)] = static_cast<float>(clay.mean_outer(row));
  mean_inner_[static_cast<std::size_t>(j)] = static_cast<float>(clay.mean_inner(row));
}

void ClaySurface::take_radii(Radii& radii, int j, std::span<const float> of) {
  const float steps = 65535.0f / widest_;
  const auto step = static_cast<std::size_t>(sector_step_);
  for (std::size_t i = 0; i < row_.size(); ++i)
    row_[i] = static_cast<std::uint16_t>(std::clamp(of[i * step] * steps + 0.5f, 0.0f, 65535.0f));
  const std::span had =
      std::span(radii.steps).subspan(row_.size() * static_cast<std::size_t>(j), row_.size());
  const auto first = std::mismatch(row_.begin(), row_.end(), had.begin()).first;
  if (first == row_.end()) return;
  const auto last = std::mismatch(row_.rbegin(), row_.rend(), had.rbegin()).first;
  const int left = static_cast<int>(first - row_.begin()),
            right = static_cast<int>(row_.rend() - last);
  std::copy(row_.begin(), row_.end(), had.begin());
  // Upload neighbouring rows together.
  if (radii.to != j) send(radii);
  const bool begun = radii.from < radii.to;
  if (!begun) radii.from = j;
  radii.to = j + 1;
  radii.left = begun ? std::min(radii.left, left) : left;
  radii.right = begun ? std::max(radii.right, right) : right;
}

void ClaySurface::send(Radii& radii) {
  if (radii.from < radii.to) {
    calls::bind_texture(radii.texture.name.get());
    calls::texture_part(radii.left, radii.from, radii.right - radii.left, radii.to - radii.from,
                        embedded() ? GL_RED_INTEGER : GL_RED, GL_UNSIGNED_SHORT,
                        &radii.steps[row_.size() * static_cast<std::size_t>(radii.from) +
                                     static_cast<std::size_t>(radii.left)],
                        sectors_);
  }
  radii.from = radii.to = 0;
}

// A height lies between the middles of two rows. Below the lowest middle and above the highest,
// that row counts.
void ClaySurface::stack() {
  heights_.resize(2 * kHeights);
  const auto used = static_cast<std::size_t>(rows_);
  const auto count = static_cast<float>(all_drawn_);
  const float highest = rows_ < all_drawn_ ? top_row() : 1.0f;
  const auto height = static_cast<float>(height_);
  std::size_t above = 0;
  for (std::size_t k = 0; k < kHeights; ++k) {
    const float y = static_cast<float>(k) / (kHeights - 1) * height;
    while (above < used && middle_[above] <= y) ++above;
    const std::size_t high = std::clamp<std::size_t>(above, 1, used - 1), low = high - 1;
    const float gap = std::max(middle_[high] - middle_[low], 1e-7f);
    const float row = static_cast<float>(low) + (y - middle_[low]) / gap;
    heights_[2 * k] = std::clamp((row + 0.5f) / count, 0.0f, highest);
    heights_[2 * k + 1] = height / (gap * count);
  }
  if (!row_at_.name) {
    row_at_ = Texture::create(GL_RG32F, kHeights, 1, GL_RG, GL_FLOAT, heights_.data());
  } else {
    calls::bind_texture(row_at_.name.get());
    calls::texture_part(0, 0, kHeights, 1, GL_RG, GL_FLOAT, heights_.data());
  }
  stacked_ = true;
}

float ClaySurface::lip() const {
  return std::min(static_cast<float>(kLipRadius), 0.5f * static_cast<float>(rim_wall()));
}

double ClaySurface::rim_wall() const {
  if (rows_ < 1) return 0.0;
  const auto top = static_cast<std::size_t>(rows_ - 1);
  return static_cast<double>(mean_outer_[top] - mean_inner_[top]);
}

float ClaySurface::radius_at(const Radii& radii, float round, float up, float lowest) const {
  const float at = std::clamp(up, 0.0f, 1.0f) * (kHeights - 1);
  const auto k = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(kHeights - 2));
  const float share =
      std::max(std::lerp(heights_[2 * k], heights_[2 * k + 2], at - static_cast<float>(k)), lowest);
  const float row = std::clamp(share * static_cast<float>(all_drawn_) - 0.5f, 0.0f,
                               static_cast<float>(rows_ - 1)),
              sector = (round - std::floor(round)) * static_cast<float>(sectors_) - 0.5f;
  const auto j = static_cast<int>(row), i = static_cast<int>(std::floor(sector));
  const int above = std::min(j + 1, rows_ - 1), left = (i + sectors_) % sectors_,
            right = (i + 1) % sectors_;
  const auto texel = [&](int x, int y) {
    return static_cast<float>(
        radii.steps[static_cast<std::size_t>(y) * row_.size() + static_cast<std::size_t>(x)]);
  };
  const float across = sector - static_cast<float>(i), along = row - static_cast<float>(j);
  return widest_ / 65535.0f *
         std::lerp(std::lerp(texel(left, j), texel(right, j), across),
                   std::lerp(texel(left, above), texel(right, above), across), along);
}

bool ClaySurface::refresh(Texture& levels_texture) {
  if (!changed_ || rows_ < 2) return false;
  const bool moved = !stacked_;
  if (moved) stack();
  tears_.refresh(std::span(middle_).first(static_cast<std::size_t>(rows_)),
                 static_cast<float>(height_), moved);
  int solid = 0;
  // Rows above the topmost are an earlier pot's.
  while (solid < rows_ - 1 && mean_inner_[static_cast<std::size_t>(solid)] == 0.0f) ++solid;
  first_wall_row_ = (static_cast<float>(solid) + 0.5f) / static_cast<float>(all_drawn_);
  levels_.height = height_;
  for (std::size_t l = 0; l < kLevels; ++l) {
    const std::size_t k = (2 * l + 1) * kHeights / (2 * kLevels);
    const auto row =
        std::min(static_cast<std::size_t>(heights_[2 * k] * static_cast<float>(all_drawn_)),
                 static_cast<std::size_t>(rows_ - 1));
    levels_.outer[l] = mean_outer_[row];
    levels_.inner[l] = mean_inner_[row];
  }
  upload(levels_, levels_texture);
  changed_ = false;
  return true;
}

double ClaySurface::mouth() const {
  return empty() ? 0.0 : static_cast<double>(mean_inner_[static_cast<std::size_t>(rows_ - 1)]);
}

// A wall of radius r and slope s at height y is visible up to an angle `a` from the front with
// cos a > (r + s (eye.y - y)) / distance.
double ClaySurface::facing(Vec3 eye) const {
  const double away = std::hypot(eye.x, eye.z);
  if (rows_ < 2 || away < 2.0 * max_radius()) return 1.0;
  double least = 1.0;
  for (std::size_t j = 1; j < static_cast<std::size_t>(rows_); ++j) {
    const double rise = std::max(static_cast<double>(middle_[j] - middle_[j - 1]), 1e-6);
    const double slope = static_cast<double>(mean_outer_[j] - mean_outer_[j - 1]) / rise;
    const double y = static_cast<double>(middle_[j]);
    // Single rings lean more than the means do.
    const double tilt = slope * (eye.y - y) - kLean * std::abs(eye.y - y);
    least = std::min(least, (static_cast<double>(mean_outer_[j]) + tilt) / away);
  }
  const double edge = least - kOutOfRound;
  return edge <= -1.0 ? 1.0 : std::acos(std::min(edge, 1.0)) / kHalfTurn;
}

// Over the near edge of the mouth, the eye sees down to where the steepest ray meets the widest
// ring.
double ClaySurface::seen_into(Vec3 eye) const {
  const double rim = height_ - kLipRadius, deepest = rim - floor_top_;
  // These are means around the axis; an uneven pot is wider in places.
  const double mouth = 1.2 * this->mouth() + 0.003, widest = 1.2 * max_radius() + 0.003;
  const double away = std::hypot(eye.x, eye.z) - mouth;
  if (away <= 0.01 || deepest <= 0.001) return 1.0;
  return std::min(std::max(eye.y - rim, 0.0) / away * (mouth + widest) / deepest, 1.0);
}

double ClaySurface::max_radius() const {
  return empty() ? 0.0 : *std::max_element(mean_outer_.begin(), mean_outer_.begin() + rows_);
}

}  // namespace onggi::render
