#include "engine/script/ring_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi::script {
namespace {

constexpr int kSlices = 200;
constexpr double kThin = 0.55;          // of a ring's wall as laid: how thin it is beaten
constexpr double kMostRadius = 0.6;     // of the vessel's radius: the thickest that a wall may be
constexpr double kMostSlope = 2.0;      // how much thicker, level, a wall gets by its slope
constexpr double kMostOfARing = 0.6;    // where less clay is missing, no ring is laid
constexpr double kLean = 0.4;           // coils from ring to ring, inwards
constexpr double kGain = 0.75;          // of the way to the line in one blow
constexpr double kSqueeze = 1.4;        // of the way to the thin wall in one blow
constexpr double kThickEnough = 1.03;   // times as planned: a blow does not thin such a wall
constexpr double kFirmness = 0.8;       // of dry clay: coils are a little wet
constexpr double kMuchWorse = 1.5;      // times: from there on another band is the worst
constexpr double kBeatenWall = 1.12;    // times as thick as planned
constexpr double kBeatenLine = 0.01;    // of the vessel's height, RMS
constexpr double kBeatenHeight = 0.05;  // of the vessel's

double ring_area(double outer, double inner) {
  return portable::kPi * (outer * outer - inner * inner);
}

// A pot's wall, ring by ring. Clay and ClayView have other means of the same.
double mean_of(std::span<const float> face) {
  double sum = 0.0;
  for (const float r : face) sum += double{r};
  return sum / static_cast<double>(face.size());
}
double mean_outer(const Clay& pot, int j) { return mean_of(pot.outer(j)); }
double mean_inner(const Clay& pot, int j) { return mean_of(pot.inner(j)); }
double mean_outer(const ClayView& pot, int j) { return pot.mean_outer(j); }
double mean_inner(const ClayView& pot, int j) { return pot.mean_inner(j); }

template <class Pot>
double height_of(const Pot& pot, int j) {
  const bool top = j + 1 == pot.rows();
  const double below = j > 0 ? 0.5 * (pot.row_height(j) - pot.row_height(j - 1)) : 0.0;
  const double above = top ? pot.rim_height() - pot.row_height(j)
                           : 0.5 * (pot.row_height(j + 1) - pot.row_height(j));
  return below + above;
}
double clay_of(const Clay& pot, int j) {
  const double area = pot.areas() != nullptr && pot.areas()->known(j)
                          ? pot.areas()->of(j)
                          : ring_area(mean_outer(pot, j), mean_inner(pot, j));
  return area * pot.row_thickness(j);
}
double clay_of(const ClayView& pot, int j) {
  return ring_area(mean_outer(pot, j), mean_inner(pot, j)) * height_of(pot, j);
}
// Clay in rows `first` to `end`, m^3.
template <class Pot>
double wall_clay(const Pot& pot, int first, int end) {
  double sum = 0.0;
  for (int j = first; j < end; ++j) sum += clay_of(pot, j);
  return sum;
}
template <class Pot>
double wall_clay(const Pot& pot) {
  return wall_clay(pot, pot.floor_rows(), pot.rows());
}

// The wall under a paddle's face.
struct Here {
  int row = 0;
  double outer = 0.0, wall = 0.0;  // m
};
template <class Pot>
Here wall_at(const Pot& pot, double height, std::optional<double> angle, double face) {
  Here here;
  int first = pot.floor_rows(), end = first;
  for (int j = pot.floor_rows(); j < pot.rows(); ++j) {
    if (pot.row_height(j) < height) here.row = j;
    if (pot.row_height(j) < height - 0.5 * face) first = j;
    if (pot.row_height(j) <= height + 0.5 * face) end = j + 1;
  }
  here.row = std::max(here.row, pot.floor_rows());
  first = std::min(first, pot.rows() - 1);
  end = std::max(end, first + 1);
  const int n = pot.sectors();
  const double turns = angle ? *angle / (2.0 * portable::kPi) : 0.0;
  const int middle = std::min(static_cast<int>((turns - std::floor(turns)) * n), n - 1);
  const double out = std::max(mean_outer(pot, here.row), face);
  const int half = angle ? static_cast<int>(0.25 * face / out / portable::kPi * n) : (n - 1) / 2;
  double count = 0.0;
  for (int j = first; j < end; ++j)
    for (int k = -half; k <= half; ++k) {
      const auto i = static_cast<std::size_t>((middle + k + n) % n);
      here.outer += double{pot.outer(j)[i]};
      here.wall += double{pot.outer(j)[i]} - double{pot.inner(j)[i]};
      count += 1.0;
    }
  here.outer /= count;
  here.wall /= count;
  return here;
}

}  // namespace

RingPlan::RingPlan(const Profile& target, double floor, const BuildingDef& law,
                   const std::optional<BeatingDef>& beating)
    : law_(law),
      beating_(beating),
      target_(target),
      floor_(floor),
      ring_height_(effects::Building::ring_height(law, {})),
      ring_wall_(0.25 * portable::kPi * law.coil * law.coil / ring_height_) {
  const double wanted = beating ? kThin * ring_wall_ : ring_wall_;
  const double step = std::max(target.height() - floor, 0.0) / kSlices;
  double clay = 0.0;
  for (int k = 0; k < kSlices; ++k) {
    const double low = floor + k * step, outer = target.outer_at(low + 0.5 * step);
    const double lean =
        step > 0.0 ? (target.outer_at(low + step) - target.outer_at(low)) / step : 0;
    const double level = std::min(std::sqrt(1.0 + lean * lean), kMostSlope);
    const double wall = std::min(wanted * level, kMostRadius * outer);
    clay += ring_area(outer, outer - wall) * step;
    // Half of what the wall gets thinner makes it wider: ln(R' / R) = ln(t / t') / 2.
    const double laid = (outer - 0.5 * wall) * std::sqrt(std::min(wall / ring_wall_, 1.0));
    slices_.push_back({clay, outer, wall, laid});
  }
  clay_ = clay;
  for (std::size_t k = slices_.size() - 1; k-- > 0;) {
    const Slice& above = slices_[k + 1];
    const double rings = (above.clay - slices_[k].clay) / ring_clay(above.laid);
    slices_[k].laid = std::min(slices_[k].laid, above.laid + kLean * law.coil * rings);
  }
}

RingPlan::Slice RingPlan::at_share(double share) const {
  const double clay = share * clay_;
  const auto above = std::ranges::lower_bound(slices_, clay, {}, &Slice::clay);
  return above == slices_.end() ? slices_.back() : *above;
}

// Of clay with `below` m^3 of the wall below it, of `all`: a pot with part of a ring too much, or
// too little, gets a wall so much thicker or thinner, and its vessel's height.
RingPlan::Slice RingPlan::place_of(double below, double all) const {
  Slice place = at_share(below / all);
  place.wall *= all / clay_;
  return place;
}

double RingPlan::ring_clay(double radius) const {
  return 2.0 * portable::kPi * std::max(radius, 0.5 * law_.coil) * ring_height_ * ring_wall_;
}

int RingPlan::rings() const {
  if (!beats()) return static_cast<int>(std::ceil((target_.height() - floor_) / ring_height_)) + 1;
  int rings = 1;
  for (double clay = 0.0; clay < clay_; ++rings) clay += ring_clay(at_share(clay / clay_).laid);
  return rings;
}

template <class Pot>
bool RingPlan::lacks(const Pot& pot, double has) const {
  if (pot.rows() == 0) return false;
  if (!beats()) return pot.rim_height() + kMostOfARing * law_.coil < target_.height();
  const double ring = ring_clay(mean_outer(pot, pot.rows() - 1) - 0.5 * law_.coil);
  return has + kMostOfARing * ring < clay_;
}

template <class Pot>
double RingPlan::next(const Pot& pot) const {
  if (pot.rows() == 0) return 0.0;
  if (!beats())
    return target_.outer_at(std::min(pot.rim_height() + law_.coil, target_.height())) -
           0.5 * law_.coil;
  const double ring = ring_clay(mean_outer(pot, pot.rows() - 1) - 0.5 * law_.coil);
  return at_share((wall_clay(pot) + 0.5 * ring) / clay_).laid - law_.drift * law_.coil;
}

template <class Pot>
Swings RingPlan::strike(const Pot& pot, double height, std::optional<double> angle,
                        double strength) const {
  if (!beats() || pot.floor_rows() >= pot.rows()) return {};
  const Here here = wall_at(pot, height, angle, beating_->face);
  const double below = wall_clay(pot, pot.floor_rows(), here.row);
  const double at = clay_of(pot, here.row);
  const double above = wall_clay(pot, here.row + 1, pot.rows());
  const double all = std::max(below + at + above, lacks(pot, below + at + above) ? clay_ : 0.0);
  if (!(here.wall > 0.0 && all > 0.0)) return {};
  const Slice place = place_of(below + 0.5 * at, all);
  // Where the outer face will be once the wall is thin, and how far that is from the line.
  const double thick = std::max(here.wall / place.wall, 1.0);
  const double ends = (here.outer - 0.5 * here.wall) * std::sqrt(thick) + 0.5 * here.wall / thick;
  const double off = place.outer - ends;
  // As in Beating: the load at which the wall folds, and the pressure between two rough plates over
  // a face whose weights come to a third of its area.
  const double stress = kFirmness * strength * beating_->yield_stress, face = beating_->face;
  const double load = portable::kPi * stress * here.wall * here.wall;
  const double moves = std::min(kGain * std::fabs(off) * load / beating_->energy, 1.0);
  const double pressure = stress * (1.0 + 2.0 * face / (3.0 * std::sqrt(3.0) * here.wall));
  const double thins = kSqueeze * std::max(here.wall - kThickEnough * place.wall, 0.0);
  const double work = pressure * thins * portable::kPi / 3.0 * face * face;
  const double squeezes = std::min(work / beating_->energy, 1.0 - moves);
  const double harder = squeezes + moves;
  return off < 0.0 ? Swings{harder, squeezes} : Swings{squeezes, harder};
}

// Calls `visit` with the place of each row's clay.
template <class Pot, class Visit>
void RingPlan::each_row(const Pot& pot, Visit&& visit) const {
  const double all = wall_clay(pot);
  double below = 0.0;
  for (int j = pot.floor_rows(); j < pot.rows(); ++j) {
    const double clay = clay_of(pot, j);
    visit(j, place_of(below + 0.5 * clay, all));
    below += clay;
  }
}

template <class Pot>
bool RingPlan::wants_blows(const Pot& pot) const {
  if (!beats() || pot.floor_rows() >= pot.rows() || lacks(pot, wall_clay(pot))) return false;
  double walls = 0.0, squares = 0.0, heights = 0.0;
  each_row(pot, [&](int j, const Slice& place) {
    const double height = height_of(pot, j);
    const double outer = mean_outer(pot, j), off = outer - place.outer;
    walls += (outer - mean_inner(pot, j)) / place.wall * height;
    squares += off * off * height;
    heights += height;
  });
  return walls > kBeatenWall * heights ||
         std::sqrt(squares / heights) > kBeatenLine * target_.height();
}

std::optional<RingPlan::Worst> RingPlan::worst(const ClayView& pot,
                                               std::optional<double> last) const {
  if (!beats() || pot.floor_rows() >= pot.rows()) return std::nullopt;
  constexpr int kMost = 32;
  struct Band {
    double bad = 0.0, off = 0.0, height = 0.0;
  };
  std::array<Band, kMost> bands{};
  const double floor = pot.floor_top(), high = std::max(pot.rim_height() - floor, 1e-6);
  const int count = std::clamp(static_cast<int>(high / beating_->face), 1, kMost);
  const auto band_of = [&](double height) {
    return std::clamp(static_cast<int>((height - floor) / high * count), 0, count - 1);
  };
  each_row(pot, [&](int j, const Slice& place) {
    Band& band = bands[static_cast<std::size_t>(band_of(pot.row_height(j)))];
    const double height = height_of(pot, j), outer = pot.mean_outer(j);
    const double thick = (outer - pot.mean_inner(j)) / place.wall - 1.0;
    const double off = outer - place.outer;
    band.bad += height * (std::max(thick, 0.0) / (kBeatenWall - 1.0) +
                          std::fabs(off) / (kBeatenLine * target_.height()));
    band.off += height * off;
    band.height += height;
  });
  const auto bad = [&](int n) {
    const Band& band = bands[static_cast<std::size_t>(n)];
    return band.height > 0.0 ? band.bad / band.height : 0.0;
  };
  int worst = 0;
  for (int n = 1; n < count; ++n)
    if (bad(n) > bad(worst)) worst = n;
  if (last && bad(worst) < kMuchWorse * bad(band_of(*last))) worst = band_of(*last);
  return Worst{floor + (worst + 0.5) / count * high,
               bands[static_cast<std::size_t>(worst)].off > 0.0};
}

bool RingPlan::lacks_a_ring(const Clay& pot) const { return lacks(pot, wall_clay(pot)); }
bool RingPlan::lacks_a_ring(const ClayView& pot) const { return lacks(pot, wall_clay(pot)); }
double RingPlan::next_ring(const Clay& pot) const { return next(pot); }
double RingPlan::next_ring(const ClayView& pot) const { return next(pot); }
Swings RingPlan::swings(const Clay& pot, double height, std::optional<double> angle,
                        double strength) const {
  return strike(pot, height, angle, strength);
}
Swings RingPlan::swings(const ClayView& pot, double height, std::optional<double> angle,
                        double strength) const {
  return strike(pot, height, angle, strength);
}
bool RingPlan::to_beat(const Clay& pot) const { return wants_blows(pot); }
bool RingPlan::to_beat(const ClayView& pot) const { return wants_blows(pot); }

bool RingPlan::beaten(const ClayView& pot) const {
  return beats() && pot.floor_rows() < pot.rows() && !lacks(pot, wall_clay(pot)) &&
         !wants_blows(pot) &&
         std::fabs(pot.rim_height() - target_.height()) <= kBeatenHeight * target_.height();
}

}  // namespace onggi::script
