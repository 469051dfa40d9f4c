#include "engine/surface/melt.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"
#include "engine/math/vec.h"

namespace onggi::surface {

std::span<const DefField<MeltDef>> MeltDef::fields() {
  static constexpr DefField<MeltDef> kFields[] = {
      {"viscosity", &MeltDef::viscosity, 10.0, 1e6, "Pa s"},
      {"tension", &MeltDef::tension, 0.05, 1.0, "N/m"},
      {"seconds", &MeltDef::seconds, 0.0, 1e5, "s"},
      {"shrinks", &MeltDef::shrinks, 0.1, 1.0, ""},
      {"even", &MeltDef::even, 0.0, 1e-3, "m"},
  };
  return kFields;
}

namespace {

constexpr int kBlocks = kSectors / kLanes;
constexpr double kCell = kRowHeight * 1e-6;  // m
constexpr double kMostLevels = 0.004;        // m, of a melt of 1 mm that runs for hours
constexpr int kMostMelted = 65535;           // units: 16 mm
constexpr int kChord = 4;                    // rows: a wet finger rounds each edge by a millimetre

/// Of the body at row j: how fast its two directions of curvature turn, 1/m, outwards > 0.
std::vector<double> curvature_of(const Surface& surface) {
  const int rows = surface.rows();
  const auto chord = [&](int j) {
    const Row &a = surface.row(std::max(j - kChord, 0)),
              &b = surface.row(std::min(j + kChord, rows - 1));
    return Vec2{b.radius - a.radius, b.height - a.height};
  };
  std::vector<double> out(static_cast<std::size_t>(rows), 0.0);
  for (int j = 0; j < rows; ++j) {
    const Vec2 before = chord(std::max(j - 1, 0)), behind = chord(std::min(j + 1, rows - 1));
    const int apart = std::min(j + 1, rows - 1) - std::max(j - 1, 0);
    const double along = length(chord(j));
    if (apart == 0 || !(along > 0.0)) continue;
    const double turned = portable::atan2(before.x * behind.y - before.y * behind.x,
                                          before.x * behind.x + before.y * behind.y);
    out[static_cast<std::size_t>(j)] =
        turned / (apart * kCell) + chord(j).y / along / surface.row(j).radius;
  }
  return out;
}

}  // namespace

Result<Melt> Melt::begin(const Surface& surface, const MeltDef& def) {
  if (const Result<void> valid = check_fields(def); !valid)
    return tl::unexpected<Problem>(valid.error());
  return Melt(surface, def);
}

Melt::Melt(const Surface& surface, const MeltDef& def)
    : surface_(&surface),
      def_(def),
      shrinks_(static_cast<int>(std::floor(def.shrinks * 1000.0 + 0.5))) {
  const auto cells = static_cast<std::size_t>(surface.rows()) * kSectors;
  melted_.assign(cells, 0);
  volume_ = surface.glaze_volume();
  if (volume_ == 0) even_ = static_cast<int>(def.even * 1e9) / kGlazeUnit;
  if (volume_ == 0 && even_ == 0) {
    stage_ = Stage::done;
    return;
  }
  height_.resize(cells);
  even_base_.emplace(surface, 0, kSectors);
}

int Melt::raw(int j, int i) const {
  if (even_ == 0) return surface_->glaze(j, i);
  return surface_->resist(j, i) ? 0 : even_;
}

void Melt::fill_row(int j) {
  const float unit = 1e-6f * static_cast<float>(kGlazeUnit * shrinks_);
  base_ = even_base_->row(j);
  int glazed = 0;
  Volume units = 0;
  for (int i = 0; i < kSectors; ++i) {
    const int glaze = raw(j, i);
    const std::size_t at = cell(j, i);
    melted_[at] = static_cast<std::uint16_t>(glaze > 0);
    height_[at] = base(i) + unit * static_cast<float>(glaze);
    glazed += glaze > 0;
    units += glaze;
  }
  glazed_cells_ += glazed;
  glazed_area_ += Volume{glazed} * surface_->row(j).area;
  lies_ += units * kGlazeUnit * surface_->row(j).area;
}

void Melt::weigh_up() {
  if (even_ > 0) volume_ = lies_;
  if (glazed_cells_ == 0) return;
  const double mean = 1e-9 * static_cast<double>(lies_) / static_cast<double>(glazed_area_);
  mean_ = static_cast<float>(mean * 1e9 / kUnit);
  const double h = mean * 1e-3 * shrinks_;
  const double fourth = def_.seconds * def_.tension * h * h * h / (3.0 * def_.viscosity);
  levels_ = std::min(std::sqrt(std::sqrt(fourth)), kMostLevels);
  look_at_body();
  // With p the phase from a cell to the n-th beside it, and q to the one above:
  //   (p + q)^4 + (p - q)^4 = 2 p^4 + 12 p^2 q^2 + 2 q^4.
  // So what the two slanting ways smooth of p^4 and q^4 is left out of the straight ones, and all
  // four together smooth (p / n w)^2 + (q / h)^2 squared: the same in every direction.
  int slant = 0;
  for (int j = 0; j < surface_->rows(); ++j) {
    const double wide = 1e-9 * surface_->row(j).width;
    const int n = std::max(static_cast<int>(kCell / wide + 0.5), 1);
    const double step = n * wide;
    const double fourth_power = levels_ * levels_ * levels_ * levels_;
    const double across = fourth_power / (6.0 * step * step * kCell * kCell);
    const double round = fourth_power / (wide * wide * wide * wide) - 2.0 * across * n * n * n * n;
    const double along = fourth_power / (kCell * kCell * kCell * kCell) - 2.0 * across;
    round_.push_back(level_kernel(round)), along_.push_back(level_kernel(along));
    across_.push_back(level_kernel(across));
    slant_.push_back(slant);
    slant = wrapped(slant + n);
  }
}

/// What levelling takes from the body's own height z, where z'' is its curvature with the sign
/// turned.
void Melt::look_at_body() {
  const int rows = surface_->rows();
  edges_.assign(static_cast<std::size_t>(rows), 0.0);
  const LevelKernel kernel =
      level_kernel(levels_ * levels_ * levels_ * levels_ / (kCell * kCell * kCell * kCell));
  const int reach = kernel.reach();
  if (reach == 0) return;
  const std::vector<double> curved = curvature_of(*surface_);
  const auto at = [&](int j) {  // no glaze flows over the ends
    const int back = 2 * rows;
    j = (j % back + back) % back;
    return curved[static_cast<std::size_t>(j < rows ? j : back - 1 - j)];
  };
  for (int j = 0; j < rows; ++j) {
    // The height of both sides over the middle's tangent.
    double up = 0.0, down = 0.0, up_slope = -0.5 * kCell * at(j), down_slope = up_slope;
    double sum = 0.0;
    for (int m = 1; m <= reach; ++m) {
      up += up_slope * kCell, down += down_slope * kCell;
      sum += static_cast<double>(kernel.weights[static_cast<std::size_t>(m)]) * (up + down);
      up_slope -= kCell * at(j + m), down_slope -= kCell * at(j - m);
    }
    edges_[static_cast<std::size_t>(j)] = 1e6 * sum;
  }
}

void Melt::level_row(int j) {
  const LevelKernel& kernel = round_[static_cast<std::size_t>(j)];
  if (kernel.idle()) return;
  const std::span<float> row(height_.data() + cell(j, 0), kSectors);
  const std::uint16_t* glazed = melted_.data() + cell(j, 0);
  const auto bare = std::find(glazed, glazed + kSectors, 0) - glazed;
  if (bare == kSectors) return level_ring(row, kernel, room_);
  // From bare place to bare place, beginning at one.
  std::vector<float> line;
  std::vector<const LevelKernel*> kernels;
  for (int n = 0, from = 0; n <= kSectors; ++n) {
    const bool ends = n == kSectors || glazed[wrapped(bare + n)] == 0;
    if (!ends) continue;
    if (n > from) {
      line.clear();
      for (int k = from; k < n; ++k)
        line.push_back(row[static_cast<std::size_t>(wrapped(bare + k))]);
      kernels.assign(line.size(), &kernel);
      level_line(line, kernels, room_);
      for (int k = from; k < n; ++k)
        row[static_cast<std::size_t>(wrapped(bare + k))] = line[static_cast<std::size_t>(k - from)];
    }
    from = n + 1;
  }
}

/// Lines from the foot up. `way`: 0 straight, else slanting to the right or to the left.
void Melt::level_columns(int block, int way) {
  const int rows = surface_->rows();
  const std::vector<LevelKernel>& all = way == 0 ? along_ : across_;
  std::vector<float> values(static_cast<std::size_t>(rows) * kLanes);
  std::vector<std::uint8_t> glazed(static_cast<std::size_t>(rows));  // lanes of a row
  std::vector<std::uint8_t> cells(values.size());
  const auto place = [&](int j, int lane) {
    const int slant = way * slant_[static_cast<std::size_t>(j)];
    return cell(j, wrapped(std::int64_t{block} * kLanes + lane + slant));
  };
  for (int j = 0; j < rows; ++j)
    for (int lane = 0; lane < kLanes; ++lane) {
      const std::size_t from = place(j, lane);
      const auto to = static_cast<std::size_t>(j * kLanes + lane);
      values[to] = height_[from];
      cells[to] = static_cast<std::uint8_t>(melted_[from]);
      glazed[static_cast<std::size_t>(j)] =
          static_cast<std::uint8_t>(glazed[static_cast<std::size_t>(j)] + cells[to]);
    }
  std::vector<const LevelKernel*> kernels;
  for (const LevelKernel& kernel : all) kernels.push_back(&kernel);
  const auto of = [&](int from, int to) {
    return std::span<const LevelKernel* const>(kernels).subspan(
        static_cast<std::size_t>(from), static_cast<std::size_t>(to - from));
  };
  // From bare place to bare place; lane by lane where lanes differ.
  const bool alike = std::ranges::all_of(glazed, [](int n) { return n == 0 || n == kLanes; });
  std::vector<float> line;
  for (int lane = 0; lane < (alike ? 1 : kLanes); ++lane) {
    const auto bare = [&](int j) {
      return cells[static_cast<std::size_t>(j * kLanes + lane)] == 0;
    };
    for (int j = 0, from = 0; j <= rows; ++j) {
      if (j < rows && !bare(j)) continue;
      if (j > from && alike) {
        level_lanes(std::span<float>(values).subspan(static_cast<std::size_t>(from * kLanes),
                                                     static_cast<std::size_t>((j - from) * kLanes)),
                    of(from, j), room_);
      } else if (j > from) {
        line.clear();
        for (int k = from; k < j; ++k)
          line.push_back(values[static_cast<std::size_t>(k * kLanes + lane)]);
        level_line(line, of(from, j), room_);
        for (int k = from; k < j; ++k)
          values[static_cast<std::size_t>(k * kLanes + lane)] =
              line[static_cast<std::size_t>(k - from)];
      }
      from = j + 1;
    }
  }
  for (int j = 0; j < rows; ++j)
    for (int lane = 0; lane < kLanes; ++lane)
      height_[place(j, lane)] = values[static_cast<std::size_t>(j * kLanes + lane)];
}

/// Units under the levelled top. The law takes each place for as thick as the mean. A thinner one
/// flows by the third power of its thickness, dh/dt ~ -(h / mean)^3, so that a crest that the law
/// would leave bare, or under nothing, keeps a film.
int Melt::wanted(int j, int i) const {
  const float edge = static_cast<float>(edges_[static_cast<std::size_t>(j)]);
  const float um = height_[cell(j, i)] + edge - base(i);
  float units = um * (1e6f / static_cast<float>(kUnit * shrinks_));
  const float from = std::min(static_cast<float>(raw(j, i) * (kGlazeUnit / kUnit)), mean_);
  if (units < from) {
    const float thin = from / mean_;
    units = from / std::sqrt(1.0f + 2.0f * thin * thin * (from - units) / mean_);
  }
  return static_cast<int>(std::min(std::floor(units + 0.5f), 1.0f * kMostMelted));
}

/// Lays what is wanted, by as much more or less everywhere as makes it the volume, and carries what
/// rounding leaves over from cell to cell.
void Melt::lay_row(int j) {
  const Volume area = surface_->row(j).area;
  base_ = even_base_->row(j);
  for (int i = 0; i < kSectors; ++i) {
    const std::size_t at = cell(j, i);
    if (melted_[at] == 0) continue;
    const Volume unit = kUnit * area;
    const double all = share_ * wanted(j, i) * static_cast<double>(unit);
    const Volume want = static_cast<Volume>(std::floor(all + 0.5)) + rest_;
    const Volume units = std::clamp<Volume>(floor_div(want + unit / 2, unit), 0, kMostMelted);
    rest_ = want - units * unit;
    melted_[at] = static_cast<std::uint16_t>(units);
    laid_ += units * unit;
  }
}

std::int64_t Melt::work(int n) {
  switch (stage_) {
    case Stage::fill:
      return fill_row(n), 2 * kSectors;
    case Stage::round:
      return level_row(n), 2 * kSectors;
    case Stage::along:
      return level_columns(n, 0), 2 * kLanes * surface_->rows();
    case Stage::across:
      return level_columns(n, 1), 2 * kLanes * surface_->rows();
    case Stage::back_across:
      return level_columns(n, -1), 2 * kLanes * surface_->rows();
    case Stage::count:
      base_ = even_base_->row(n);
      for (int i = 0; i < kSectors; ++i)
        if (melted_[cell(n, i)] != 0)
          laid_ += std::int64_t{wanted(n, i)} * kUnit * surface_->row(n).area;
      return 2 * kSectors;
    default:
      return lay_row(n), 2 * kSectors;
  }
}

void Melt::next_stage() {
  if (stage_ == Stage::fill) weigh_up();
  if (stage_ == Stage::count) {
    share_ = laid_ > 0 ? static_cast<double>(volume_) / static_cast<double>(laid_) : 0.0;
    laid_ = 0;
  }
  stage_ = static_cast<Stage>(static_cast<int>(stage_) + 1);
  next_ = 0;
  if (glazed_cells_ == 0) stage_ = Stage::done;
  if (stage_ != Stage::done) return;
  rest_ = volume_ - laid_;
  even_base_.reset();
  std::vector<float>().swap(height_);  // assigning {} would keep the memory
  for (auto* kernels : {&round_, &along_, &across_}) std::vector<LevelKernel>().swap(*kernels);
}

bool Melt::go_on(std::int64_t cells) {
  while (!done() && cells > 0) {
    const bool in_blocks = stage_ >= Stage::along && stage_ <= Stage::back_across;
    cells -= work(next_++);
    if (next_ == (in_blocks ? kBlocks : surface_->rows())) next_stage();
  }
  return done();
}

Volume Melt::volume() const {
  Volume sum = rest_;
  for (int j = 0; j < surface_->rows(); ++j) {
    Volume units = 0;
    for (int i = 0; i < kSectors; ++i) units += glaze(j, i);
    sum += units * kUnit * surface_->row(j).area;
  }
  return sum;
}

}  // namespace onggi::surface
