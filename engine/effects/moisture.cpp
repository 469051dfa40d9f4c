#include "engine/effects/moisture.h"

#include <algorithm>
#include <utility>

#include "engine/math/portable.h"

namespace onggi {

std::span<const DefField<MoistureDef>> MoistureDef::fields() {
  static constexpr DefField<MoistureDef> kFields[] = {
      {"wetting_time", &MoistureDef::wetting_time, 0.05, 60.0, "s"},
      {"drying_time", &MoistureDef::drying_time, 1.0, 36000.0, "s"},
      {"fire_time", &MoistureDef::fire_time, 1.0, 36000.0, "s"},
      {"softening", &MoistureDef::softening, 0.05, 1.0, ""},
      {"weakening", &MoistureDef::weakening, 0.005, 1.0, ""},
      {"air", &MoistureDef::air, 0.0, 1.0, ""},
      {"sponge_height", &MoistureDef::sponge_height, 0.0, 1.0, "m"},
  };
  return kFields;
}

namespace effects {

double softness(const MoistureDef& def, double wetness) noexcept {
  return 1.0 + wetness * (def.softening - 1.0);
}

double strength(const MoistureDef& def, double wetness) noexcept {
  return wetness > 0.0 ? portable::exp(wetness * portable::log(def.weakening)) : 1.0;
}

Moisture::Moisture(const MoistureDef& def, int rows, int room) : rows_(rows) {
  if (def.sponge_height > 0.0) row_.assign(static_cast<std::size_t>(room), -def.air);
  air_ = def.sponge_height > 0.0 ? def.air : 0.0;
}

void Moisture::soak_or_dry(const MoistureDef& def, const Clay& clay, double seconds, bool sponge,
                           std::span<const double> heights, bool fire) noexcept {
  const double drying_time = fire ? def.fire_time : def.drying_time;
  const double faded = portable::exp(-seconds / drying_time);
  // Under a sponge both happen: w' = (1 - w) / wetting_time - (w - air) / drying_time. The wetness
  // approaches `towards` at the sum of both rates.
  const double still_to_soak = sponge ? portable::exp(-seconds / def.wetting_time) : 1.0;
  const double towards =
      sponge ? (drying_time + def.air * def.wetting_time) / (drying_time + def.wetting_time)
             : def.air;
  if (row_.empty()) {
    mean_ = towards + (mean_ - towards) * faded * still_to_soak;
    if (mean_ < 1e-9) mean_ = 0.0;
    return;
  }
  // The room's dampness may have changed.
  if (air_ != def.air)
    for (double& wet : row_) wet += (air_ - def.air) / decay_;
  air_ = def.air;
  mean_ = air_ + (mean_ - air_) * faded;
  decay_ *= faded;
  // Before the factor loses digits; once in 14 time constants.
  if (decay_ < 1e-6) {
    for (double& wet : row_) wet *= decay_;
    decay_ = 1.0;
  }
  if (!sponge) return;
  // Applied to a row that has already dried as all rows do: less * (w - air) + more.
  const Soaked soaked{still_to_soak, (towards - air_) * (1.0 - faded * still_to_soak)};
  if (heights.empty()) {
    for (const int row : clay.stored()) soak_row(row, soaked);
  } else {
    soak_bands(clay, 0.5 * def.sponge_height, heights, soaked);
  }
  mean_ = std::clamp(mean_, 0.0, 1.0);
  soaked_ += std::exchange(most_taken_, 0.0);
}

// Where bands overlap, two sponges bring no more water than one.
void Moisture::soak_bands(const Clay& clay, double reach, std::span<const double> heights,
                          const Soaked& soaked) noexcept {
  const double lowest = std::ranges::min(heights);
  int done = 0;
  for (const double height : {lowest, heights.front(), heights.back()})
    for (int j = std::max(done, clay.first_row_above(height - reach));
         j < clay.rows() && clay.row_height(j) < height + reach; done = ++j)
      soak_row(clay.stored(j), soaked);
}

void Moisture::soak_row(int stored, const Soaked& soaked) noexcept {
  double& row = row_[static_cast<std::size_t>(stored)];
  const double dry = row * decay_;
  const double wet = soaked.less * dry + soaked.more;
  row = wet / decay_;
  mean_ += (wet - dry) / static_cast<double>(rows_);
  most_taken_ = std::max(most_taken_, wet - dry);
}

void Moisture::row_added(const Clay& clay, int to, double wetness, double share) noexcept {
  if (row_.empty()) {
    mean_ += share * (wetness - mean_);
    return;
  }
  row_[static_cast<std::size_t>(to)] = (wetness - air_) / decay_;
  mean_ += (of_row(to) - mean_) / clay.rows();
  rows_ = clay.rows();
}

void Moisture::row_divided(const Clay& clay, int from, int to) noexcept {
  if (row_.empty()) return;
  row_[static_cast<std::size_t>(to)] = row_[static_cast<std::size_t>(from)];
  mean_ += (of_row(to) - mean_) / clay.rows();
  rows_ = clay.rows();
}

void Moisture::rows_joined(const Clay& clay, int from, int to, double share) noexcept {
  if (row_.empty()) return;
  double& row = row_[static_cast<std::size_t>(from)];
  const double both = of_row(from) + of_row(to);
  row += share * (row_[static_cast<std::size_t>(to)] - row);
  mean_ = std::clamp((mean_ * rows_ - both + of_row(from)) / clay.rows(), 0.0, 1.0);
  rows_ = clay.rows();
}

void Moisture::count_rows(const Clay& clay) noexcept {
  if (row_.empty() || clay.rows() == rows_) return;
  double sum = 0.0;
  for (const int row : clay.stored()) sum += of_row(row);
  rows_ = clay.rows();
  mean_ = std::clamp(sum / rows_, 0.0, 1.0);
}

double Moisture::at(const Clay& clay, double height) const {
  if (row_.empty()) return mean_;
  return of_row(clay.stored(std::clamp(clay.first_row_above(height), 0, clay.rows() - 1)));
}

void Moisture::add_to(StateHash& hash, const Clay& clay) const {
  if (row_.empty()) return;
  hash.add(decay_);
  hash.add(soaked_);
  for (const int row : clay.stored()) hash.add(row_[static_cast<std::size_t>(row)]);
}

}  // namespace effects
}  // namespace onggi
