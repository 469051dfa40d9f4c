#include "kiosk/render/clay_surface.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace onggi::render {
namespace {

// Radii wrap round the axis and end at foot and rim.
Texture radius_texture(int sectors, int rows) {
  Texture t = Texture::create(GL_R32F, sectors, rows, GL_RED, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  return t;
}

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
  scratch_.resize(static_cast<std::size_t>(sectors_));
  tears_.reset(all_drawn_, row_step_);
  outer_ = radius_texture(sectors_, all_drawn_);
  inner_ = radius_texture(sectors_, all_drawn_);
}

void ClaySurface::show(const ClayView& clay) {
  if (clay.room() != all_rows_ || clay.sectors() != all_sectors_) make_room(clay);
  seen_ = 0;
  update(clay);
}

// Rows that left are no longer torn.
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
  if (height_ != clay.rim_height()) stacked_ = false;
  height_ = clay.rim_height();
  floor_top_ = clay.floor_top();
  use_rows(clay.rows());
  for (int row = 0; row < clay.rows(); ++row) {
    if (clay.placed_at(row) > seen_) tears_.note(row, clay.torn(row));
    if (row % row_step_ != 0 || row / row_step_ >= rows_) continue;
    const int j = row / row_step_;
    if (clay.shaped_at(row) > seen_) upload_row(j, clay, row);
    float& middle = middle_[static_cast<std::size_t>(j)];
    const auto now = static_cast<float>(clay.row_height(row));
    if (middle != now) stacked_ = false;
    middle = now;
  }
  seen_ = clay.change();
  changed_ = true;
}

void ClaySurface::upload_row(int j, const ClayView& clay, int row) {
  const auto upload = [&](const Texture& texture, std::span<const float> radii) {
    if (sector_step_ > 1) {
      for (std::size_t i = 0; i < scratch_.size(); ++i)
        scratch_[i] = radii[i * static_cast<std::size_t>(sector_step_)];
      radii = scratch_;
    }
    calls::bind_texture(texture.name.get());
    calls::texture_part(0, j, sectors_, 1, GL_RED, GL_FLOAT, radii.data());
  };
  upload(outer_, clay.outer(row));
  upload(inner_, clay.inner(row));
  mean_outer_[static_cast<std::size_t>(j)] = static_cast<float>(clay.mean_outer(row));
  mean_inner_[static_cast<std::size_t>(j)] = static_cast<float>(clay.mean_inner(row));
}

// A height is between the middles of two rows; below the lowest and above the highest it is theirs.
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
  if (rows_ < 1) return 0.0f;
  const auto top = static_cast<std::size_t>(rows_ - 1);
  return std::min(static_cast<float>(kLipRadius), 0.5f * (mean_outer_[top] - mean_inner_[top]));
}

bool ClaySurface::refresh(Texture& levels_texture) {
  if (!changed_ || rows_ < 2) return false;
  const bool moved = !stacked_;
  if (moved) stack();
  tears_.refresh(std::span(middle_).first(static_cast<std::size_t>(rows_)),
                 static_cast<float>(height_), moved);
  int solid = 0;
  while (solid < rows_ && mean_inner_[static_cast<std::size_t>(solid)] == 0.0f) ++solid;
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

double ClaySurface::max_radius() const {
  return empty() ? 0.0 : *std::max_element(mean_outer_.begin(), mean_outer_.begin() + rows_);
}

}  // namespace onggi::render
