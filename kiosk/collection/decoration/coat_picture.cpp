#include "kiosk/collection/decoration/coat_picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>

#include "kiosk/collection/decoration/decorate.h"

namespace onggi::decoration {

namespace {

using surface::kSectors;

constexpr std::array<float, 3> kWax{0.62f, 0.50f, 0.27f};  // until the kiln burns it
constexpr float kWaxHides = 0.55f;
constexpr double kRawGlazeHides = 1.2e-4;             // m
constexpr int kSlopeUnit = 64, kLevel = 128;          // of form()
constexpr int kDepthUnit = 4 * surface::kNanometres;  // nm
constexpr int kTopsAcross = CoatPicture::kTileColumns + 2;
constexpr int kWholeBead = 2 * CoatPicture::kLeastBead;  // um: it moves the outline by all of it
constexpr int kBelowLip = 12;  // rows over which a bead runs out below the lip, which has none
constexpr int kFeels = 3;      // cells from which a slope is told: neighbours, evened with theirs

std::uint64_t next_change() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

std::uint8_t byte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 255.0f));
}

float share_hidden(double coat, double hides) {
  return static_cast<float>(-std::expm1(-coat / hides));
}

/// Nearest byte to a slope, rise over way.
std::uint8_t slope_byte(int rise, int way) {
  return byte(kLevel + 0.5f + kSlopeUnit * static_cast<float>(rise) / static_cast<float>(way));
}

}  // namespace

CoatPicture::CoatPicture(const surface::Surface& surface, const Palette& palette)
    : palette_(palette), rows_(surface.rows()) {
  const auto cells = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(kSectors);
  paint_.resize(cells);
  form_.assign(cells, {kLevel, kLevel, 0, 0});
  const auto tiles = static_cast<std::size_t>(tiles_down() * tiles_across());
  beads_.assign(tiles * (kTileRows / kBeadRows) * (kTileColumns / kBeadColumns), 0);
  change_ = next_change();
  changes_.assign(tiles, change_);
  stale_.assign(tiles, false);
  has_glaze_.assign(tiles, false);
  middle_form_ = {kLevel, kLevel, 0, 0};
  const surface::Row& last = surface.row(rows_ - 1);
  has_middle_ = rows_ > 1 && last.part == surface::Part::floor &&
                last.radius < surface::kLeastRadius + 2e-6 * surface::kRowHeight;
  know_shares(palette);
  tell_rows(surface);
}

void CoatPicture::know_shares(const Palette& palette) {
  for (std::size_t p = 0; p < std::min(palette.pigments.size(), hides_.size()); ++p)
    for (int code = 0; code < surface::kCodes; ++code)
      hides_[p][static_cast<std::size_t>(code)] =
          share_hidden(1e-9 * surface::thickness_of(code), palette.pigments[p].hides);
  palette_.pigments.resize(surface::kPigments);
  for (std::size_t units = 0; units < glaze_hides_.size(); ++units)
    glaze_hides_[units] =
        share_hidden(1e-9 * static_cast<double>(units) * surface::kGlazeUnit, kRawGlazeHides);
}

void CoatPicture::tell_rows(const surface::Surface& surface) {
  using surface::Part;
  const auto share = [&](int row) { return static_cast<float>(row) / static_cast<float>(rows_); };
  int outside = 0, lip = 0, inside = 0;  // rows up to the end of each part
  for (int j = 0; j < rows_; ++j) {
    const Part part = surface.row(j).part;
    if (part == Part::outside) outside = j + 1;
    if (part <= Part::lip) lip = j + 1;
    if (part <= Part::inside) inside = j + 1;
  }
  outside_ = outside;
  lip = std::max(lip, outside);
  inside = std::max(inside, lip);
  lip_from_ = share(outside), lip_to_ = share(lip), floor_from_ = share(inside);
  const double top = outside > 0 ? surface.row(outside - 1).height : 0.0;
  by_height_.resize(kHeights);
  int outer = 0, inner = inside;
  for (int n = 0; n < kHeights; ++n) {
    const double height = top * n / (kHeights - 1);
    while (outer + 1 < outside && surface.row(outer).height < height) ++outer;
    while (inner - 1 > lip && surface.row(inner - 1).height < height) --inner;
    // Between the middles of two rows, so that no step of a row is seen.
    const auto between = [&](int low, int high) {
      const double a = surface.row(low).height, b = surface.row(high).height;
      const double part = b > a ? std::clamp((height - a) / (b - a), 0.0, 1.0) : 0.0;
      return static_cast<float>((low + 0.5 + part * (high - low)) / rows_);
    };
    const float at_outer = between(std::max(outer - 1, 0), outer);
    const float at_inner =
        inside > lip ? between(std::min(inner, inside - 1), std::max(inner - 1, lip)) : lip_to_;
    by_height_[static_cast<std::size_t>(n)] = {at_outer, at_inner};
  }
}

void CoatPicture::touch(int from, int to, int first, int last) {
  const int low = std::clamp(from - kFeels, 0, rows_ - 1) / kTileRows;
  const int high = std::clamp(to - 1 + kFeels, 0, rows_ - 1) / kTileRows;
  const bool all_round = last - first >= kSectors;
  const auto left = static_cast<int>(surface::floor_div(first - kFeels, kTileColumns));
  const auto right = static_cast<int>(surface::floor_div(last - 1 + kFeels, kTileColumns));
  for (int down = low; down <= high; ++down)
    for (int n = all_round ? 0 : left; n <= (all_round ? tiles_across() - 1 : right); ++n) {
      const int across = surface::wrapped(std::int64_t{n} * kTileColumns) / kTileColumns;
      stale_[static_cast<std::size_t>(down * tiles_across() + across)] = true;
    }
}

void CoatPicture::touch_all() { stale_.assign(stale_.size(), true); }

void CoatPicture::fire(bool fired, const surface::Melt* melt) {
  if (!fired) melt = nullptr;
  if (fired != fired_ || melt != melt_) touch_all();
  fired_ = fired;
  melt_ = melt;
}

bool CoatPicture::draw(const surface::Surface& surface, int most) {
  for (std::size_t n = 0; n < stale_.size(); ++n) {
    if (!stale_[n]) continue;
    if (most-- <= 0) return true;
    const auto tile = static_cast<int>(n);
    draw_tile(surface, tile / tiles_across(), tile % tiles_across());
    stale_[n] = false;
    changes_[n] = change_ = next_change();
  }
  if (middle_stale_) even_middle();
  const bool melted = melt_ != nullptr;
  const bool glazed = melted || std::ranges::find(has_glaze_, true) != has_glaze_.end();
  if (glazed == glazed_ && melted == melted_) return false;
  // The fourth value of form() has another meaning now; what has melted was drawn with it.
  const bool again = glazed != glazed_ && !melted;
  glazed_ = glazed;
  melted_ = melted;
  change_ = next_change();
  if (!again) return false;
  touch_all();
  return draw(surface, most);
}

CoatPicture::Cover CoatPicture::cover(const surface::Surface& surface, int j, int i) const {
  Cover out;  // the colour times its share, until the end
  const auto lay = [&](const std::array<float, 3>& light, float share) {
    for (std::size_t k = 0; k < 3; ++k) out.light[k] += share * (light[k] - out.light[k]);
    out.share += share * (1.0f - out.share);
  };
  const surface::Strata strata = surface.slip(j, i);
  if (strata.word() != 0)
    for (int k = surface::kStrata - 1; k >= 0; --k) {
      const surface::Stratum stratum = strata.at(k);
      if (stratum.code == 0) continue;
      const auto pigment = static_cast<std::size_t>(stratum.pigment);
      const Palette::Coat& coat = palette_.pigments[pigment];
      lay(fired_ ? coat.fired : coat.raw, hides_[pigment][static_cast<std::size_t>(stratum.code)]);
    }
  if (const int smoke = surface.smoke(j, i); smoke > 0)
    lay(kCarbon, static_cast<float>(smoke) / surface::kMostSmoke);
  if (!fired_ && surface.resist(j, i)) lay(kWax, kWaxHides);
  if (const int units = surface.glaze(j, i); units > 0 && !fired_)
    lay(palette_.raw_glaze, glaze_hides_[static_cast<std::size_t>(units)]);
  if (out.share > 0.0f)
    for (float& light : out.light) light /= out.share;
  return out;
}

void CoatPicture::find_tops(const surface::Surface& surface, int down, int across) {
  const int first = across * kTileColumns - 1;
  surface::EvenBase base(surface, first, kTopsAcross);
  tops_.resize(std::size_t{kTileRows + 2} * kTopsAcross);
  for (int row = 0; row < kTileRows + 2; ++row) {
    const int j = std::clamp(down * kTileRows + row - 1, 0, rows_ - 1);
    const std::span<const int> even = base.row(j);
    for (int column = 0; column < kTopsAcross; ++column) {
      const int i = surface::wrapped(first + column);
      tops_[static_cast<std::size_t>(row * kTopsAcross + column)] =
          even[static_cast<std::size_t>(column)] +
          (melt_ != nullptr ? melt_->fired(j, i) : surface.glaze(j, i) * surface::kGlazeUnit);
    }
  }
}

/// `row`, `column`: of its tile.
CoatPicture::Texel CoatPicture::form_at(const surface::Surface& surface, int j, int i, int row,
                                        int column) const {
  const int* top = &tops_[static_cast<std::size_t>((row + 1) * kTopsAcross + column + 1)];
  const int apart = std::min(j + 1, rows_ - 1) - std::max(j - 1, 0);
  constexpr int kRow = surface::kRowHeight * static_cast<int>(surface::kNanometres);
  Texel out{slope_byte(top[kTopsAcross] - top[-kTopsAcross], std::max(apart, 1) * kRow),
            slope_byte(top[1] - top[-1], 2 * std::max(surface.row(j).width, 1)), 0, 0};
  if (melt_ != nullptr) {
    constexpr int kUnits = surface::kGlazeUnit / surface::Melt::kUnit;
    const int glaze = (melt_->glaze(j, i) + kUnits / 2) / kUnits;
    out[3] = static_cast<std::uint8_t>(std::min(glaze, 255));
  } else {
    out[2] = static_cast<std::uint8_t>(std::min(std::max(-*top, 0) / kDepthUnit, 255));
    out[3] =
        static_cast<std::uint8_t>(glazed_ ? surface.glaze(j, i) : kPolish * surface.burnish(j, i));
  }
  return out;
}

void CoatPicture::draw_tile(const surface::Surface& surface, int down, int across) {
  bool glaze = false;
  find_tops(surface, down, across);
  for (int j = down * kTileRows; j < std::min((down + 1) * kTileRows, rows_); ++j)
    for (int i = across * kTileColumns; i < (across + 1) * kTileColumns; ++i) {
      const Cover over = cover(surface, j, i);
      const std::size_t at = static_cast<std::size_t>(j) * static_cast<std::size_t>(kSectors) +
                             static_cast<std::size_t>(i);
      Texel& paint = paint_[at];
      if (has_middle_ && j == rows_ - 1) {
        paint = middle_paint_;
        form_[at] = middle_form_;
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) paint[k] = byte(255.0f * std::sqrt(over.light[k]) + 0.5f);
      paint[3] = byte(255.0f * over.share + 0.5f);
      form_[at] = form_at(surface, j, i, j - down * kTileRows, i - across * kTileColumns);
      glaze = glaze || surface.glaze(j, i) > 0;
    }
  draw_beads(surface, down, across);
  has_glaze_[static_cast<std::size_t>(down * tiles_across() + across)] = glaze;
  middle_stale_ = middle_stale_ || (has_middle_ && down == tiles_down() - 1);
}

void CoatPicture::draw_beads(const surface::Surface& surface, int down, int across) {
  constexpr int kDown = kTileRows / kBeadRows, kAcross = kTileColumns / kBeadColumns;
  for (int row = 0; row < kDown; ++row)
    for (int column = 0; column < kAcross; ++column) {
      const int from = down * kTileRows + row * kBeadRows,
                first = across * kTileColumns + column * kBeadColumns;
      std::int64_t sum = 0;
      for (int j = from; j < std::min(from + kBeadRows, outside_); ++j)
        for (int i = first; i < first + kBeadColumns; ++i) sum += surface.relief(j, i);
      const auto mean = static_cast<int>(sum / (kBeadRows * kBeadColumns));
      const int of_it = std::clamp(mean - kLeastBead, 0, kWholeBead - kLeastBead);
      const int below = std::clamp(outside_ - from - kBeadRows, 0, kBelowLip);
      const std::int64_t out =
          std::int64_t{mean} * of_it * below / (std::int64_t{kWholeBead - kLeastBead} * kBelowLip);
      beads_[static_cast<std::size_t>(((down * kDown + row) * tiles_across() + across) * kAcross +
                                      column)] =
          static_cast<std::uint8_t>(std::min<std::int64_t>(out / kBeadUnit, 255));
    }
}

/// The mean of the ring beside it; level.
void CoatPicture::even_middle() {
  middle_stale_ = false;
  const std::size_t ring = static_cast<std::size_t>(rows_ - 2) * kSectors;
  std::array<double, 3> light{};
  double cover = 0.0, deep = 0.0, coat = 0.0;
  for (std::size_t at = ring; at < ring + kSectors; ++at) {
    for (std::size_t k = 0; k < 3; ++k)
      light[k] += 1.0 * paint_[at][k] * paint_[at][k] * paint_[at][3];
    cover += paint_[at][3], deep += form_[at][2], coat += form_[at][3];
  }
  const auto mean = [](double sum) { return byte(static_cast<float>(sum / kSectors) + 0.5f); };
  Texel paint{0, 0, 0, mean(cover)};
  for (std::size_t k = 0; k < 3 && cover > 0.0; ++k)
    paint[k] = byte(static_cast<float>(std::sqrt(light[k] / cover)) + 0.5f);
  const Texel form{kLevel, kLevel, mean(deep), mean(coat)};
  if (paint == middle_paint_ && form == middle_form_) return;
  middle_paint_ = paint, middle_form_ = form;
  std::fill(paint_.end() - kSectors, paint_.end(), paint);
  std::fill(form_.end() - kSectors, form_.end(), form);
  change_ = next_change();
  std::fill(changes_.end() - tiles_across(), changes_.end(), change_);
}

}  // namespace onggi::decoration
