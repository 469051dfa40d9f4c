#include "engine/clay/row_division.h"

#include <algorithm>
#include <cmath>

namespace onggi::clay {
namespace {

constexpr float kNothing = 0.0f;

// The amount taken from the square of the lower half's radius and added to the upper half's: a
// quarter of the row's height times the gentler of both slopes; zero at a turning point.
float tilt(float below, float here, float above, float share_below, float share_above) {
  const float rise = (here - below) * (here + below) * share_below;
  const float on = (above - here) * (above + here) * share_above;
  if (rise > kNothing && on > kNothing) return rise < on ? rise : on;
  if (rise < kNothing && on < kNothing) return rise > on ? rise : on;
  return kNothing;
}

// Share of the way from row `j`'s middle to its neighbour's at which its halves' middles lie.
float share_of_way(const Clay& clay, int j, int neighbour) {
  const double own = clay.row_thickness(j);
  return static_cast<float>(0.5 * own / (own + clay.row_thickness(neighbour)));
}

double mean_of(float a, float b, double share_of_b) {
  return double{a} + share_of_b * (double{b} - double{a});
}

// The rows beside two that are joined, and the heights of all four middles.
struct Neighbours {
  Neighbours(const Clay& clay, int j, int lowest)
      : below(j > lowest ? j - 1 : j), above(j + 2 < clay.rows() ? j + 2 : j + 1) {
    const double low = clay.row_thickness(j);
    const double high = clay.row_thickness(j + 1);
    upper_share = high / (low + high);
    const double middle = clay.row_height(j) + 0.5 * high;
    // Beyond the last row the outline goes straight on.
    if (below < j)
      low_share = (clay.row_height(j) - clay.row_height(below)) / (middle - clay.row_height(below));
    if (above > j + 1)
      high_share =
          (clay.row_height(above) - clay.row_height(j + 1)) / (clay.row_height(above) - middle);
  }
  int below, above;
  double upper_share;
  double low_share = 1.0, high_share = 1.0;  // of the way from a neighbour to the new row
};

double error_of(const Neighbours& at, float below, float low, float high, float above) {
  const double joined = mean_of(low, high, at.upper_share);
  const double from_below = at.low_share < 1.0 ? double{below} : joined;
  const double from_above = at.high_share < 1.0 ? double{above} : joined;
  const double was_low = from_below + at.low_share * (joined - from_below) - double{low};
  const double was_high = from_above + at.high_share * (joined - from_above) - double{high};
  return std::max(std::fabs(was_low), std::fabs(was_high));
}

// Sets the row's extent and area, and marks it to be drawn.
void measure(Clay& clay, int j) {
  clay.set_extent(j, *std::ranges::max_element(clay.outer(j)),
                  *std::ranges::min_element(clay.inner(j)));
  clay.areas()->set(j, clay.measured_area(j));
  clay.mark_dirty(j);
}

}  // namespace

bool may_divide(const Clay& clay, int j) noexcept {
  if (clay.spare_rows() == 0 || clay.areas()->torn(j) || clay.areas()->changed(j)) return false;
  const int floor = clay.floor_rows();
  if (floor == clay.rows()) return true;
  const double quarter = 0.25 * clay.row_thickness(j);
  if (j == floor - 1) return clay.row_height(j) + quarter < clay.floor_top();
  if (j == floor) return clay.row_height(j) - quarter >= clay.floor_top();
  return true;
}

void divide_row(Clay& clay, int j, double volume) noexcept {
  const bool solid = j < clay.floor_rows();
  const int lowest = solid ? 0 : clay.floor_rows();
  const int end = solid ? clay.floor_rows() : clay.rows();
  const bool ends = j == lowest || j + 1 == end;
  const float share_below = ends ? kNothing : share_of_way(clay, j, j - 1);
  const float share_above = ends ? kNothing : share_of_way(clay, j, j + 1);
  clay.insert_row(j + 1, solid);

  const int below = j == lowest ? j : j - 1;
  const int above = j + 1 == end ? j : j + 2;
  const float* out_below = clay.outer(below).data();
  const float* in_below = clay.inner(below).data();
  const float* out_above = clay.outer(above).data();
  const float* in_above = clay.inner(above).data();
  const std::span<float> out = clay.pressable_outer(j);
  const std::span<float> in = clay.pressable_inner(j);
  const std::span<float> upper_out = clay.pressable_outer(j + 1);
  const std::span<float> upper_in = clay.pressable_inner(j + 1);
  const auto wall_min = static_cast<float>(clay.def().wall_min);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const float o = out[i];
    const float n = in[i];
    const float more_out = tilt(out_below[i], o, out_above[i], share_below, share_above);
    const float more_in =
        solid ? kNothing : tilt(in_below[i], n, in_above[i], share_below, share_above);
    const float low_out = std::sqrt(o * o - more_out);
    const float high_out = std::sqrt(o * o + more_out);
    const float low_in = std::sqrt(n * n - more_in);
    const float high_in = std::sqrt(n * n + more_in);
    // Where the faces lean different ways, a half might get thinner than a wall may be.
    const bool leans = low_out - low_in >= wall_min && high_out - high_in >= wall_min;
    out[i] = leans ? low_out : o;
    in[i] = leans ? low_in : n;
    upper_out[i] = leans ? high_out : o;
    upper_in[i] = leans ? high_in : n;
  }
  measure(clay, j);
  measure(clay, j + 1);
  const double area = clay.areas()->of(j) + clay.areas()->of(j + 1);
  clay.set_row_thickness(j, volume / area);
  clay.set_row_thickness(j + 1, volume / area);
  clay.restack_divided(j);
}

bool may_join(const Clay& clay, int j) noexcept {
  if (j + 1 >= clay.rows() || j + 1 == clay.floor_rows()) return false;
  const RowAreas& areas = *clay.areas();
  for (const int row : {j, j + 1})
    if (areas.torn(row) || areas.changed(row) || !areas.known(row)) return false;
  return !clay.was_moved(j) && !clay.was_moved(j + 1);
}

double join_error(const Clay& clay, int j) noexcept {
  const bool solid = j < clay.floor_rows();
  const Neighbours at(clay, j, solid ? 0 : clay.floor_rows());
  double most = 0.0;
  for (std::size_t i = 0; i < clay.outer(j).size(); ++i)
    most = std::max(most, error_of(at, clay.outer(at.below)[i], clay.outer(j)[i],
                                   clay.outer(j + 1)[i], clay.outer(at.above)[i]));
  for (std::size_t i = 0; !solid && i < clay.inner(j).size(); ++i)
    most = std::max(most, error_of(at, clay.inner(at.below)[i], clay.inner(j)[i],
                                   clay.inner(j + 1)[i], clay.inner(at.above)[i]));
  return most;
}

void join_rows(Clay& clay, int j, double volume) noexcept {
  const bool solid = j < clay.floor_rows();
  const double low = clay.row_thickness(j);
  const double high = clay.row_thickness(j + 1);
  const auto upper_share = static_cast<float>(high / (low + high));
  const std::span<const float> upper_out = clay.outer(j + 1);
  const std::span<const float> upper_in = clay.inner(j + 1);
  const std::span<float> out = clay.pressable_outer(j);
  const std::span<float> in = clay.pressable_inner(j);
  const auto wall_min = static_cast<float>(clay.def().wall_min);
  const auto both = [upper_share](float lower, float upper) {
    return std::sqrt(lower * lower + (upper - lower) * (upper + lower) * upper_share);
  };
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = both(out[i], upper_out[i]);
    if (!solid) in[i] = std::min(both(in[i], upper_in[i]), out[i] - wall_min);
  }
  clay.erase_row(j + 1);
  measure(clay, j);
  clay.set_row_thickness(j, volume / clay.areas()->of(j));
  clay.restack_divided(j);
}

bool restore_row_count(Clay& clay, History* history, int element_budget) noexcept {
  const int wanted = clay.def().rows;
  for (int rows = std::max(1, element_budget / clay.stride()); rows > 0; --rows) {
    if (clay.rows() == wanted) return true;
    const int top = clay.rows() - 1;
    const bool fewer = clay.rows() > wanted;
    const bool solid = clay.floor_rows() == clay.rows();
    if (history != nullptr) {
      history->keep_row(clay, fewer ? clay.stored(top) : clay.next_spare());
      fewer ? history->note_erased(top, solid) : history->note_inserted(top + 1);
    }
    fewer ? clay.erase_row(top) : clay.insert_row(top + 1, solid);
  }
  return clay.rows() == wanted;
}

}  // namespace onggi::clay
