#include "engine/surface/wipe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/surface/micrometres.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

std::span<const DefField<WipeDef>> WipeDef::fields() {
  static constexpr DefField<WipeDef> kFields[] = {
      {"width", &WipeDef::width, 0.002, 0.03, "m"},
      {"leaves", &WipeDef::leaves, 0.0, 2e-4, "m"},
      {"ridge", &WipeDef::ridge, 5e-5, 5e-4, "m"},
      {"wet_time", &WipeDef::wet_time, 1.0, 3600.0, "s"},
  };
  return kFields;
}

namespace {

constexpr double kAlong = 3000.0;       // um before and behind a piece that still get some
constexpr std::int64_t kWidest = 8000;  // um: a ridge is no wider, however much was taken
constexpr std::int64_t kEvenShare = 6,
                       kSoftShare = 14;  // of ten: as wide as it is level, as it goes

/// The finger's way from one station to the next.
class Finger {
 public:
  Finger(Surface& surface, const WipeDef& def)
      : surface_(surface), def_(def), half_(micrometres(def.width) / 2) {}

  void go(const Station& from, const Station& to) {
    const Volume taken = take(from, to);
    if (taken == 0) return;
    const Volume left = taken / 2;
    find_sides(from, to, taken);
    give_back(pile(sides_[0], left) + pile(sides_[1], taken - left), row_of(surface_, to.along));
  }

 private:
  /// Lifts the wet glaze over the film.
  Volume take(const Station& from, const Station& to) {
    wiped_.clear();
    const auto dry = static_cast<std::int64_t>(def_.wet_time * 1e3);
    const std::int64_t wet = std::max<std::int64_t>(dry - to.age, 0);
    const int film = static_cast<int>(nanometres(def_.leaves) / kGlazeUnit);
    Volume taken = 0;
    each_cell_in(surface_, piece(surface_, from, to, -half_, half_, -half_, half_),
                 [&](int j, int i) {
                   const int glaze = surface_.glaze(j, i);
                   const std::int64_t over = std::max(glaze - film, 0);
                   const auto units = static_cast<int>(over * wet / dry * to.pressure / kWhole);
                   if (units == 0) return;
                   surface_.set_glaze(j, i, glaze - units);
                   wiped_.emplace_back(j, i);
                   taken += Volume{units} * kGlazeUnit * surface_.row(j).area;
                 });
    return taken;
  }

  /// The cells beside the way, to its left and to its right, on which the ridges come to lie. Those
  /// before and behind it get less and less, so that a ridge goes smoothly round a bend. What was
  /// wiped stays so.
  void find_sides(const Station& from, const Station& to, Volume taken) {
    sides_[0].cells.clear(), sides_[1].cells.clear();
    sides_[0].weights = sides_[1].weights = 0.0;
    const int row = row_of(surface_, to.along);
    const std::int64_t on =
        (std::int64_t{to.round} - from.round) * surface_.row(row).width / (kParts * kNanometres);
    const std::int64_t up = std::int64_t{to.along} - from.along;
    const auto way = static_cast<std::int64_t>(std::sqrt(static_cast<double>(on * on + up * up)));
    const std::int64_t wide = std::min(
        taken / 2 / std::max<Volume>(nanometres(def_.ridge) * std::max<std::int64_t>(way, 100), 1),
        kWidest);
    const auto even = static_cast<double>(wide * kEvenShare / 10);
    const auto ends = static_cast<double>(wide * kSoftShare / 10 + kRowHeight);
    const int film = static_cast<int>(nanometres(def_.leaves) / kGlazeUnit);
    const Corner a = beside(surface_, from, 0), b = beside(surface_, to, 0);
    const auto half = static_cast<double>(half_);
    const auto reach = static_cast<std::int64_t>(half + ends);
    const int first = row_of(surface_, std::min(a.along, b.along) - reach);
    const int last = row_of(surface_, std::max(a.along, b.along) + reach);
    // As each_cell_near(), in doubles: there are thousands of cells.
    for (int j = first; j <= last; ++j) {
      const double um = static_cast<double>(surface_.row(j).width) / (kParts * kNanometres);
      const auto up_ = static_cast<double>(b.along - a.along);
      const double on_ = static_cast<double>(b.round - a.round) * um;
      const double length = std::max(std::sqrt(on_ * on_ + up_ * up_), 1e-3);
      const auto y = static_cast<double>(std::int64_t{j} * kRowHeight + kRowHeight / 2 - a.along);
      const auto parts = static_cast<std::int64_t>(static_cast<double>(reach) / um) + kParts;
      const std::int64_t begin = floor_div(std::min(a.round, b.round) - parts, kParts);
      const std::int64_t end = std::min(floor_div(std::max(a.round, b.round) + parts, kParts),
                                        begin + kSectors - 1);  // each cell once
      const double area = surface_.row(j).area;
      for (std::int64_t n = begin; n <= end; ++n) {
        const double x = static_cast<double>(n * kParts + kParts / 2 - a.round) * um;
        const double left = (x * up_ - y * on_) / length;
        if (std::abs(left) <= half || std::abs(left) >= half + ends) continue;
        const double ahead = (x * on_ + y * up_) / length;
        const double past = std::max({-ahead, ahead - length, 0.0});
        if (past >= kAlong) continue;
        const double off = std::abs(left) - half;
        const int i = wrapped(n);
        if (surface_.glaze(j, i) <= film || surface_.resist(j, i)) continue;
        const double share =
            area * (1.0 - past / kAlong) * (off <= even ? 1.0 : (ends - off) / (ends - even));
        Side& side = sides_[left > 0.0 ? 0 : 1];
        side.cells.push_back({j, i, share});
        side.weights += share;
      }
    }
  }

  struct Side {
    struct Share {
      int row = 0, sector = 0;
      double weight = 0.0;
    };
    std::vector<Share> cells;
    double weights = 0.0;
  };
  /// Returns what finds no room.
  Volume pile(const Side& side, Volume volume) {
    double weights = side.weights;
    for (const Side::Share& at : side.cells) {
      const double part = std::min(at.weight / weights, 1.0);
      const auto share = static_cast<Volume>(static_cast<double>(volume) * part);
      volume -= lay_glaze(surface_, at.row, at.sector, share);
      weights = std::max(weights - at.weight, at.weight);
    }
    return volume;
  }

  /// Where the ridges are full, at an end of the outline for one, the glaze stays under the finger.
  /// Its cells have room for it but for what older rests took of that, which is the row's rest
  /// again.
  void give_back(Volume volume, int row) {
    for (const auto& [j, i] : wiped_) volume -= lay_glaze(surface_, j, i, volume);
    surface_.set_rest(row, Surface::kGlazeRest, surface_.rest(row, Surface::kGlazeRest) + volume);
  }

  Surface& surface_;
  const WipeDef& def_;
  std::int64_t half_;
  std::vector<std::pair<int, int>> wiped_;
  std::array<Side, 2> sides_;
};

}  // namespace

Work wipe(Surface& surface, const WipeDef& def, std::span<const Station> stations) {
  Finger finger(surface, def);
  for (std::size_t n = 1; n < stations.size(); ++n)
    if (stations[n].pressure > 0) finger.go(stations[n - 1], stations[n]);
  return {};
}

}  // namespace onggi::surface
