#include "kiosk/render/clay_surface.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

// Radii wrap round the axis and end at foot and rim.
Texture radius_texture(int sectors, int rows, const std::vector<float>& texels) {
  Texture t = Texture::create(GL_R32F, sectors, rows, GL_RED, GL_FLOAT, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  return t;
}

}  // namespace

void ClaySurface::set_grid(const view::GridShape& shape) {
  shape_ = shape;
  row_step_ = (shape.rows + kMost - 1) / kMost;
  sector_step_ = (shape.sectors + kMost - 1) / kMost;
  rows_ = shape.rows / std::max(row_step_, 1);
  sectors_ = shape.sectors / std::max(sector_step_, 1);
  seen_ = false;
  if (rows_ < 1 || sectors_ < 1) return;
  mean_outer_.assign(static_cast<std::size_t>(rows_), 0.0f);
  mean_inner_.assign(static_cast<std::size_t>(rows_), 0.0f);
  middle_.resize(static_cast<std::size_t>(rows_));
  for (int j = 0; j < rows_; ++j)
    middle_[static_cast<std::size_t>(j)] = (static_cast<float>(j) + 0.5f) *
                                           static_cast<float>(shape.height) /
                                           static_cast<float>(rows_);
  stacked_ = false;
  tears_.reset(rows_, row_step_);
  fill(shape.lump_outer, shape.lump_inner);
}

void ClaySurface::fill(double outer, double inner) {
  const auto count = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(sectors_);
  std::vector<float> texels(count, static_cast<float>(outer));
  outer_ = radius_texture(sectors_, rows_, texels);
  const auto r = static_cast<float>(inner);
  for (int j = 0; j < rows_; ++j) {
    const bool solid = (j + 0.5) * shape_.height / rows_ < shape_.floor_height;
    const auto row = static_cast<std::size_t>(j);
    mean_outer_[row] = static_cast<float>(outer);
    mean_inner_[row] = solid ? 0.0f : r;
    std::fill_n(texels.begin() + static_cast<std::ptrdiff_t>(j) * sectors_, sectors_,
                mean_inner_[row]);
  }
  inner_ = radius_texture(sectors_, rows_, texels);
  seen_ = outer > 0;
  changed_ = true;
}

void ClaySurface::update(std::span<const view::RowUpdate> rows) {
  if (rows_ < 1 || sectors_ < 1) return;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  const auto whole = static_cast<std::size_t>(shape_.sectors);
  for (const view::RowUpdate& row : rows) {
    if (row.row < 0 || row.row >= shape_.rows || row.radii.size() != 2 * whole) continue;
    tears_.note(row.row, row.torn);
    if (row.row % row_step_ != 0 || row.row / row_step_ >= rows_) continue;
    const int j = row.row / row_step_;
    const float* outer = row.radii.data();
    const float* inner = outer + whole;
    if (sector_step_ > 1) {
      scratch_.resize(2 * static_cast<std::size_t>(sectors_));
      for (int i = 0; i < sectors_; ++i) {
        scratch_[static_cast<std::size_t>(i)] = outer[i * sector_step_];
        scratch_[static_cast<std::size_t>(sectors_ + i)] = inner[i * sector_step_];
      }
      outer = scratch_.data();
      inner = outer + sectors_;
    }
    glBindTexture(GL_TEXTURE_2D, outer_.name.get());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, j, sectors_, 1, GL_RED, GL_FLOAT, outer);
    glBindTexture(GL_TEXTURE_2D, inner_.name.get());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, j, sectors_, 1, GL_RED, GL_FLOAT, inner);
    means_of(j, outer, inner);
    if (!row.place) continue;
    float& middle = middle_[static_cast<std::size_t>(j)];
    const auto now = static_cast<float>(row.place->middle);
    if (middle != now || shape_.height != row.place->rim) stacked_ = false;
    middle = now;
    shape_.height = row.place->rim;
    shape_.floor_height = row.place->floor;
  }
  if (!rows.empty()) changed_ = seen_ = true;
}

void ClaySurface::means_of(int row, const float* outer, const float* inner) {
  // Sixteen rays tell the light enough about a ring.
  const int step = std::max(1, sectors_ / 16);
  float o = 0, i = 0;
  int n = 0;
  for (int k = 0; k < sectors_; k += step, ++n) {
    o += outer[k];
    i += inner[k];
  }
  mean_outer_[static_cast<std::size_t>(row)] = o / static_cast<float>(n);
  mean_inner_[static_cast<std::size_t>(row)] = i / static_cast<float>(n);
}

// A height is between the middles of two rows; below the lowest and above the highest it is theirs.
void ClaySurface::stack() {
  heights_.resize(2 * kHeights);
  const auto count = static_cast<float>(rows_);
  const auto height = static_cast<float>(shape_.height);
  std::size_t above = 0;
  for (std::size_t k = 0; k < kHeights; ++k) {
    const float y = static_cast<float>(k) / (kHeights - 1) * height;
    while (above < middle_.size() && middle_[above] <= y) ++above;
    const std::size_t high = std::clamp<std::size_t>(above, 1, middle_.size() - 1), low = high - 1;
    const float gap = std::max(middle_[high] - middle_[low], 1e-7f);
    const float row = static_cast<float>(low) + (y - middle_[low]) / gap;
    heights_[2 * k] = std::clamp((row + 0.5f) / count, 0.0f, 1.0f);
    heights_[2 * k + 1] = height / (gap * count);
  }
  if (!row_at_.name) {
    row_at_ = Texture::create(GL_RG32F, kHeights, 1, GL_RG, GL_FLOAT, heights_.data());
  } else {
    glBindTexture(GL_TEXTURE_2D, row_at_.name.get());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kHeights, 1, GL_RG, GL_FLOAT, heights_.data());
  }
  stacked_ = true;
}

float ClaySurface::lip() const {
  if (mean_outer_.empty()) return 0.0f;
  return std::min(static_cast<float>(shape_.lip_radius),
                  0.5f * (mean_outer_.back() - mean_inner_.back()));
}

bool ClaySurface::refresh(Texture& levels_texture) {
  if (!changed_ || rows_ < 2) return false;
  const bool moved = !stacked_;
  if (moved) stack();
  tears_.refresh(middle_, static_cast<float>(shape_.height), moved);
  int solid = 0;
  while (solid < rows_ && mean_inner_[static_cast<std::size_t>(solid)] == 0.0f) ++solid;
  first_wall_row_ = (static_cast<float>(solid) + 0.5f) / static_cast<float>(rows_);
  levels_.height = shape_.height;
  for (std::size_t l = 0; l < kLevels; ++l) {
    const std::size_t k = (2 * l + 1) * kHeights / (2 * kLevels);
    const auto row = std::min(static_cast<std::size_t>(heights_[2 * k] * static_cast<float>(rows_)),
                              static_cast<std::size_t>(rows_ - 1));
    levels_.outer[l] = mean_outer_[row];
    levels_.inner[l] = mean_inner_[row];
  }
  upload(levels_, levels_texture);
  changed_ = false;
  return true;
}

double ClaySurface::max_radius() const {
  return mean_outer_.empty() ? 0.0 : *std::max_element(mean_outer_.begin(), mean_outer_.end());
}

}  // namespace onggi::render
