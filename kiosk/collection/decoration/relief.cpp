#include "kiosk/collection/decoration/relief.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/surface/even_base.h"

namespace onggi::decoration {

namespace {

constexpr double kMetresOfTop = 1e-9;  // Surface::top() is in nm

/// Whole cells that a span of `parts` pixels gives to one: [from, to), never none.
struct Span {
  int from = 0, to = 0;
};
Span cells_of(int pixel, int pixels, int cells) {
  const auto at = [&](int edge) {
    return static_cast<int>(std::int64_t{edge} * cells / std::max(pixels, 1));
  };
  const int from = at(pixel);
  return {from, std::max(at(pixel + 1), from + 1)};
}

/// Heights of all cells over the reference body, nm, without the grain of slip's codes: under a
/// viewer's gloss it would glitter.
class EvenTops {
 public:
  explicit EvenTops(const surface::Surface& surface) : surface_(surface) {
    surface::EvenBase base(surface, 0, surface::kSectors);
    tops_.reserve(static_cast<std::size_t>(surface.rows()) * surface::kSectors);
    for (int j = 0; j < surface.rows(); ++j) {
      const auto row = base.row(j);
      for (int i = 0; i < surface::kSectors; ++i)
        tops_.push_back(row[static_cast<std::size_t>(i)] +
                        surface.glaze(j, i) * surface::kGlazeUnit);
    }
  }
  /// Rise over way at a cell, along the rows and round the pot.
  std::array<double, 2> slopes_at(int j, int i) const {
    const int below = std::max(j - 1, 0), above = std::min(j + 1, surface_.rows() - 1);
    const int left = surface::wrapped(i - 1), right = surface::wrapped(i + 1);
    constexpr double kRow = surface::kRowHeight * double{surface::kNanometres};
    const double along = at(above, i) - at(below, i), round = at(j, right) - at(j, left);
    return {along / (std::max(above - below, 1) * kRow),
            round / (2.0 * std::max(surface_.row(j).width, 1))};
  }

 private:
  int at(int j, int i) const {
    return tops_[static_cast<std::size_t>(j) * surface::kSectors + static_cast<std::size_t>(i)];
  }
  const surface::Surface& surface_;
  std::vector<int> tops_;
};

std::uint8_t normal_byte(double part) {
  return static_cast<std::uint8_t>(std::lround(127.5 * (part + 1.0)));
}

}  // namespace

double height_at(const surface::Surface& surface, double across, double down) {
  const double column = across * surface::kSectors - 0.5;
  const double row = std::clamp(down * surface.rows() - 0.5, 0.0, surface.rows() - 1.0);
  const double left = std::floor(column);
  const auto low = static_cast<int>(row);
  const int high = std::min(low + 1, surface.rows() - 1);
  const int i = surface::wrapped(static_cast<std::int64_t>(left)), next = surface::wrapped(i + 1);
  const auto between = [&](int j) {
    return std::lerp(double(surface.top(j, i)), double(surface.top(j, next)), column - left);
  };
  return kMetresOfTop * std::lerp(between(low), between(high), row - low);
}

double mean_height(const surface::Surface& surface, double across, double down, double wide,
                   double high) {
  const auto cells = [](double middle, double size, int all) {
    const auto from = static_cast<std::int64_t>(std::ceil((middle - 0.5 * size) * all - 0.5));
    const auto to = static_cast<std::int64_t>(std::ceil((middle + 0.5 * size) * all - 0.5));
    if (to > from) return std::array{from, to};
    const auto own = static_cast<std::int64_t>(std::floor(middle * all));
    return std::array{own, own + 1};
  };
  const auto [first, last] = cells(across, std::min(wide, 1.0), surface::kSectors);
  const auto [from, to] = cells(down, high, surface.rows());
  double sum = 0.0;
  for (std::int64_t j = from; j < to; ++j) {
    const auto row = static_cast<int>(std::clamp<std::int64_t>(j, 0, surface.rows() - 1));
    for (std::int64_t i = first; i < last; ++i) sum += surface.top(row, surface::wrapped(i));
  }
  return kMetresOfTop * sum / static_cast<double>((to - from) * (last - first));
}

Unrolled normals_of(const surface::Surface& surface, int width, int height, double share) {
  const EvenTops tops(surface);
  Unrolled out{width, height, {}};
  out.rgba.reserve(4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    const Span rows = cells_of(y, height, surface.rows());
    for (int x = 0; x < width; ++x) {
      const Span sectors = cells_of(x, width, surface::kSectors);
      double along = 0.0, round = 0.0;
      for (int j = rows.from; j < rows.to; ++j)
        for (int i = sectors.from; i < sectors.to; ++i) {
          const auto [a, r] = tops.slopes_at(std::min(j, surface.rows() - 1), i);
          along += a, round += r;
        }
      const double scale = share / ((rows.to - rows.from) * (sectors.to - sectors.from));
      along *= scale, round *= scale;
      const double size = std::sqrt(1.0 + along * along + round * round);
      out.rgba.insert(out.rgba.end(), {normal_byte(-round / size), normal_byte(along / size),
                                       normal_byte(1.0 / size), 255});
    }
  }
  return out;
}

}  // namespace onggi::decoration
