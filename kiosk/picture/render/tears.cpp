#include "kiosk/picture/render/tears.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace onggi::render {

void Tears::reset(int rows, int row_step) {
  row_step_ = std::max(row_step, 1);
  // The last drawn row also stands for the remaining ones.
  torn_.assign(
      static_cast<std::size_t>(std::max(rows, 0) + 1) * static_cast<std::size_t>(row_step_), 0);
  torn_rows_ = 0;
  changed_ = false;
}

void Tears::note(int row, bool torn) {
  if (row < 0 || static_cast<std::size_t>(row) >= torn_.size()) return;
  std::uint8_t& now = torn_[static_cast<std::size_t>(row)];
  if ((now != 0) == torn) return;
  now = torn ? 1 : 0;
  torn_rows_ += torn ? 1 : -1;
  changed_ = true;
}

void Tears::measure(std::span<const float> middles, float height) {
  const float step = height / (kHeights - 1);
  const auto sample = [step](float y, bool up) {
    const float k = up ? std::ceil(y / step) : std::floor(y / step);
    return static_cast<int>(std::clamp(k, 0.0f, static_cast<float>(kHeights - 1)));
  };
  marked_.assign(kHeights, 0);
  for (std::size_t r = 0; r < torn_.size(); ++r) {
    if (torn_[r] == 0) continue;
    const std::size_t j = std::min(r / static_cast<std::size_t>(row_step_), middles.size() - 1);
    const float from = j == 0 ? 0.0f : 0.5f * (middles[j - 1] + middles[j]);
    const float to = j + 1 == middles.size() ? height : 0.5f * (middles[j] + middles[j + 1]);
    // Keep a ring that lies between two samples.
    const int first = sample(from, true), last = std::max(first, sample(to, false));
    for (int k = first; k <= last; ++k) marked_[static_cast<std::size_t>(k)] = 1;
  }
  // Two sweeps: a sample's distance is its neighbour's plus one step.
  distance_.assign(kHeights, kFurthest);
  for (std::size_t k = 1; k < kHeights; ++k)
    distance_[k] =
        marked_[k] != marked_[k - 1] ? step : std::min(distance_[k - 1] + step, kFurthest);
  for (std::size_t k = kHeights - 1; k-- > 0;)
    distance_[k] =
        std::min(distance_[k], marked_[k] != marked_[k + 1] ? step : distance_[k + 1] + step);
  for (std::size_t k = 0; k < kHeights; ++k)
    if (marked_[k] == 0) distance_[k] = -distance_[k];
}

void Tears::refresh(std::span<const float> middles, float height, bool moved) {
  if (!any() || middles.empty() || !(changed_ || moved)) return;
  measure(middles, height);
  if (!texture_.name) {
    texture_ = Texture::create(GL_R32F, kHeights, 1, GL_RED, GL_FLOAT, distance_.data());
  } else {
    calls::bind_texture(texture_.name.get());
    calls::texture_part(0, 0, kHeights, 1, GL_RED, GL_FLOAT, distance_.data());
  }
  changed_ = false;
}

}  // namespace onggi::render
