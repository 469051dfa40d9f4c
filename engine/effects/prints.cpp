#include "engine/effects/prints.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <iterator>

#include "engine/effects/effect_list.h"
#include "engine/math/portable.h"

namespace onggi {

std::span<const DefField<PrintsDef, int>> PrintsDef::counts() {
  static constexpr DefField<PrintsDef, int> kCounts[] = {
      {"paddle", &PrintsDef::paddle, plain, grid, ""},
  };
  return kCounts;
}

std::span<const DefField<PrintsDef>> PrintsDef::fields() {
  static constexpr DefField<PrintsDef> kFields[] = {
      {"pitch", &PrintsDef::pitch, 5e-4, 0.01, "m"},
      {"rings", &PrintsDef::rings, 0.0, 0.02, "m"},
      {"depth", &PrintsDef::depth, 5e-5, 0.002, "m"},
  };
  return kFields;
}

std::span<const std::string_view> paddle_faces() {
  static constexpr std::string_view kFaces[] = {"plain", "cord", "grid"};
  return kFaces;
}

std::optional<int> find_paddle_face(std::string_view name) {
  const auto found = std::ranges::find(paddle_faces(), name);
  if (found == paddle_faces().end()) return std::nullopt;
  return static_cast<int>(found - paddle_faces().begin());
}

namespace effects {
namespace {

constexpr double kFingertip = 0.004;  // m: so far to each side a hand smooths the wall
constexpr double kFarAway = 0.1;      // rad: the hand comes back elsewhere
constexpr float kWhole = static_cast<float>(portable::kPi);

// The clay below two heights, m^3; low <= high.
struct Below {
  double low, high;
};
Below clay_below(const Clay& clay, const Volume& volume, double low, double high) {
  Below below{};
  double sum = 0.0;
  const auto share = [&](int j, double height) {
    return std::clamp((height - clay.row_height(j)) / clay.row_thickness(j) + 0.5, 0.0, 1.0);
  };
  int j = 0;
  const auto go_up = [&](double height) {
    const int row = std::min(clay.first_row_above(height), clay.rows() - 1);
    // The height lies in that row or in the one below it.
    for (; j < row - 1; ++j) sum += volume.of_row(j);
    double here = sum;
    for (int k = j; k <= row; ++k) here += share(k, height) * volume.of_row(k);
    return here;
  };
  below.low = go_up(low);
  below.high = go_up(high);
  return below;
}

// Heights for rising amounts of clay below them.
class Heights {
 public:
  Heights(const Clay& clay, const Volume& volume) : clay_(clay) {
    double sum = 0.0;
    for (int j = 0; j < clay.rows(); ++j) below_.push_back(sum += volume.of_row(j));
  }
  double of(double below) const {
    const auto row = std::ranges::lower_bound(below_, below);
    if (row == below_.end()) return clay_.rim_height();
    const auto j = static_cast<int>(row - below_.begin());
    const double from = j > 0 ? below_[static_cast<std::size_t>(j - 1)] : 0.0;
    const double share = *row > from ? (below - from) / (*row - from) : 0.0;
    return clay_.row_height(j) + (share - 0.5) * clay_.row_thickness(j);
  }

 private:
  const Clay& clay_;
  std::vector<double> below_;
};

std::uint32_t step_of(const StageWork& work) {
  return work.tick.history != nullptr ? static_cast<std::uint32_t>(work.tick.history->depth()) : 0;
}

// -pi .. pi.
float nearest_turn(float angle) {
  while (angle > kWhole) angle -= 2.0f * kWhole;
  while (angle < -kWhole) angle += 2.0f * kWhole;
  return angle;
}

}  // namespace

bool Prints::wanted(const Effects& def) { return def.prints.has_value(); }

void Prints::note(const Mark& mark) noexcept {
  if (count_ == kMost) {
    first_ = (first_ + 1) % kMost;
    --count_;
    live_ = std::min(live_, count_);
  }
  at(count_) = mark;
  at(count_++).name = ++names_;
  ++live_;
  for (std::size_t& back : back_)
    if (back > 0 && ++back > count_) back = 0;
}

// Mark `n` goes, and the earlier ones move up.
void Prints::drop(std::size_t n) noexcept {
  for (std::size_t& back : back_) {
    if (back == count_ - n) back = 0;
    if (back > count_ - n) --back;
  }
  if (n >= count_ - live_) --live_;
  for (; n > 0; --n) at(n) = at(n - 1);
  first_ = (first_ + 1) % kMost;
  --count_;
}

// Share of field `n` over which no later field lies, as far as a few heights and angles tell.
double Prints::bare(std::size_t n) const noexcept {
  constexpr std::size_t kHeights = 3, kAngles = 256;
  const Mark& under = at(n);
  std::array<std::bitset<kAngles>, kHeights> over;
  const auto angle = [](double of) { return of * kAngles / (2.0 * portable::kPi); };
  const auto wrap = [](int k) { return static_cast<std::size_t>(k & (int{kAngles} - 1)); };
  for (std::size_t later = n + 1; later < count_; ++later) {
    const Mark& mark = at(later);
    if (mark.kind != Print::smoothed || mark.side != under.side) continue;
    if (mark.high <= under.low || mark.low >= under.high) continue;
    const auto from = static_cast<int>(std::ceil(angle(double{mark.angle} - double{mark.half})));
    const auto to = static_cast<int>(std::floor(angle(double{mark.angle} + double{mark.half})));
    for (std::size_t k = 0; k < kHeights; ++k) {
      const double share = (static_cast<double>(k) + 0.5) / kHeights;
      const double height = under.low + share * (under.high - under.low);
      if (height < mark.low || height > mark.high) continue;
      for (int each = from; each < to; ++each) over[k].set(wrap(each));
    }
  }
  const auto from = static_cast<int>(std::floor(angle(double{under.angle} - double{under.half})));
  const auto to = static_cast<int>(std::ceil(angle(double{under.angle} + double{under.half})));
  int all = 0, bare = 0;
  for (int each = from; each < to && each < from + int{kAngles}; ++each)
    for (const std::bitset<kAngles>& height : over) ++all, bare += height.test(wrap(each)) ? 0 : 1;
  return all > 0 ? static_cast<double>(bare) / all : 0.0;
}

// Where there are as many fields as may be, that one of a few goes that later ones cover most; the
// older ones have their turn first. Undo of the later ones then lacks it.
void Prints::make_room_for_field() noexcept {
  constexpr std::size_t kTried = 8;
  std::size_t fields = 0, oldest = count_;
  for (std::size_t n = count_ - live_; n < count_; ++n)
    if (at(n).kind == Print::smoothed && ++fields == 1) oldest = n;
  if (fields < kMostSmoothed) return;
  if (looked_at_ < oldest || looked_at_ >= count_) looked_at_ = oldest;
  std::size_t found = oldest, tried = 0;
  double least = 2.0;
  for (std::size_t n = looked_at_; n < count_ && tried < kTried && least > 0.0; ++n) {
    if (at(n).kind != Print::smoothed) continue;
    ++tried;
    const double share = bare(n);
    if (share < least) least = share, found = n;
    looked_at_ = n + 1;
  }
  drop(found);
}

void Prints::count_live() noexcept {
  for (live_ = 0; live_ < count_ && at(count_ - 1 - live_).kind != kFreshLump;) ++live_;
  back_.fill(0);
}

void Prints::note_cut(int j, double gone) noexcept {
  if (live_ == 0) return;
  if (first_cut_ == end_cut_) first_cut_ = end_cut_ = j;
  // Volume comes from the foot up.
  for (; end_cut_ <= j; ++end_cut_) cut_[static_cast<std::size_t>(end_cut_)] = {};
  cut_[static_cast<std::size_t>(j)].gone = gone;
}

// A row is cut evenly from its foot to its top: a place within it keeps its share of the row.
void Prints::lower(const StageWork& work) noexcept {
  if (first_cut_ == end_cut_) return;
  keep_places(step_of(work));
  Cut foot;
  for (int j = 0; j < first_cut_; ++j) foot.before += work.volume->of_row(j);
  const std::span<Cut> rows = std::span(cut_).subspan(
      static_cast<std::size_t>(first_cut_), static_cast<std::size_t>(end_cut_ - first_cut_));
  Cut below = foot;
  for (int j = first_cut_; j < end_cut_; ++j) {
    Cut& row = cut_[static_cast<std::size_t>(j)];
    row.before = below.before + work.volume->of_row(j) + row.gone;
    row.gone += below.gone;
    below = row;
  }
  const auto gone_below = [&](double place) {
    const auto row = std::ranges::lower_bound(rows, place, {}, &Cut::before);
    if (row == rows.end()) return rows.back().gone;
    const Cut& under = row == rows.begin() ? foot : *std::prev(row);
    const double share = (place - under.before) / (row->before - under.before);
    return under.gone + std::max(share, 0.0) * (row->gone - under.gone);
  };
  for (std::size_t n = count_ - live_; n < count_; ++n) {
    Mark& mark = at(n);
    mark.low -= gone_below(mark.low);
    mark.high -= gone_below(mark.high);
  }
  first_cut_ = end_cut_ = 0;
}

// Of whole steps, as many as there is room for.
void Prints::keep_places(std::uint32_t step) noexcept {
  const auto was = [this](std::size_t n) -> Was& { return was_[(first_was_ + n) % kMostCut]; };
  if (was_count_ > 0 && was(was_count_ - 1).step == step) return;
  while (was_count_ + live_ > kMostCut) {
    const std::uint32_t oldest = was(0).step;
    for (; was_count_ > 0 && was(0).step == oldest; --was_count_)
      first_was_ = (first_was_ + 1) % kMostCut;
  }
  for (std::size_t n = count_ - live_; n < count_; ++n)
    if (const Mark& mark = at(n); mark.step < step)
      was(was_count_++) = {mark.low, mark.high, mark.name, step};
}

void Prints::put_back(std::uint32_t step) noexcept {
  for (; was_count_ > 0; --was_count_) {
    const Was& was = was_[(first_was_ + was_count_ - 1) % kMostCut];
    if (was.step < step) return;
    std::size_t n = 0;
    for (std::size_t end = count_; n < end;) {
      const std::size_t middle = (n + end) / 2;
      at(middle).name < was.name ? n = middle + 1 : end = middle;
    }
    if (n == count_ || at(n).name != was.name) continue;
    at(n).low = was.low;
    at(n).high = was.high;
  }
}

// Puts `mark` where of a face from `low` to `high` lies on the wall above `foot`; false if nothing
// does.
bool Prints::place(const StageWork& work, double low, double high, double foot,
                   Mark& mark) noexcept {
  const double face = high - low;
  const double from = std::max(low, foot), to = std::min(high, work.clay.rim_height());
  if (!(to > from) || work.volume == nullptr) return false;
  mark.step = step_of(work);
  const Below below = clay_below(work.clay, *work.volume, from, to);
  mark.low = below.low, mark.high = below.high;
  mark.from = static_cast<float>(-1.0 + 2.0 * (from - low) / face);
  mark.to = static_cast<float>(1.0 - 2.0 * (high - to) / face);
  return true;
}

void Prints::strike(const StageWork& work, const Print& print) noexcept {
  Mark mark;
  if (!(print.deep > 0.0) || !place(work, print.low, print.high, work.clay.floor_top(), mark))
    return;
  mark.angle = static_cast<float>(print.angle);
  mark.half = static_cast<float>(print.half);
  mark.wide = static_cast<float>(print.wide);
  mark.tall = static_cast<float>(print.tall);
  mark.deep = static_cast<float>(print.deep);
  mark.kind = print.kind;
  mark.side = print.side;
  mark.left = print.left;
  note(mark);
  back_.fill(0);  // what is smoothed from now on lies over it
}

// A hand that goes on along the wall widens what it smoothed, while that stays a low field. So a
// ring under a turning pot is one mark, and a stroke upwards is a stack of them.
bool Prints::goes_on(Mark& last, const Mark& more) const noexcept {
  const double low = std::min(last.low, more.low), high = std::max(last.high, more.high);
  if (last.side != more.side || last.step != more.step || high - low > 2.0 * (more.high - more.low))
    return false;
  const float off = nearest_turn(more.angle - last.angle);
  const float beyond = std::fabs(off) + more.half - last.half;
  if (last.half < kWhole && beyond > 0.0f) {
    if (beyond > static_cast<float>(kFarAway)) return false;
    last.half = std::min(last.half + 0.5f * beyond, kWhole);
    last.angle = nearest_turn(last.angle + (off < 0.0f ? -0.5f : 0.5f) * beyond);
  }
  if (more.low < last.low) last.from = more.from;
  if (more.high > last.high) last.to = more.to;
  last.low = low;
  last.high = high;
  return true;
}

void Prints::run(const StageWork& work) noexcept {
  for (std::size_t n = 0; n < back_.size(); ++n) {
    const HandThere& hand = work.tick.hand[n];
    const double out = length(Vec2{hand.at.x, hand.at.z});
    if (live_ == 0 || !(hand.normal > 0.0) || !hand.on_wall || !(out > kFingertip)) continue;
    const double up = std::max(hand.smooths, kFingertip);
    Mark mark;
    if (!place(work, hand.at.y - up, hand.at.y + up, 0.0, mark)) continue;
    mark.angle = static_cast<float>(portable::atan2(hand.at.z, hand.at.x));
    mark.half = static_cast<float>(kFingertip / out);
    mark.kind = Print::smoothed;
    mark.side = hand.side;
    if (back_[n] > 0 && goes_on(at(count_ - back_[n]), mark)) continue;
    make_room_for_field();
    note(mark);
    back_[n] = 1;
  }
}

std::vector<Print> Prints::seen(const Clay& clay, const Volume& volume) const {
  std::vector<Print> all;
  all.reserve(live_);
  const Heights heights(clay, volume);
  for (std::size_t n = count_ - live_; n < count_; ++n) {
    const Mark& mark = at(n);
    Print print;
    print.kind = static_cast<Print::Kind>(mark.kind);
    print.side = mark.side;
    print.low = heights.of(mark.low), print.high = heights.of(mark.high);
    print.from = double{mark.from}, print.to = double{mark.to};
    print.angle = double{mark.angle}, print.half = double{mark.half};
    print.wide = double{mark.wide}, print.tall = double{mark.tall};
    print.deep = double{mark.deep};
    print.left = mark.left;
    all.push_back(print);
  }
  return all;
}

void Prints::forget(Clay&, const Laid& laid) noexcept {
  if (laid.fresh) {
    Mark mark;
    mark.step = static_cast<std::uint32_t>(laid.step);
    mark.kind = kFreshLump;
    note(mark);
  } else {
    while (count_ > 0 && at(count_ - 1).step >= laid.step) --count_;
    put_back(static_cast<std::uint32_t>(laid.step));
  }
  count_live();
}

void Prints::add_to(StateHash& hash, const Clay&) const {
  hash.add(static_cast<std::uint64_t>(live_));
  for (std::size_t n = count_ - live_; n < count_; ++n) {
    const Mark& mark = at(n);
    hash.add(std::uint64_t{mark.left} << 9 | std::uint64_t{mark.kind} << 1 |
             (mark.side == WallSide::inside ? 1 : 0));
    for (const double v :
         {mark.low, mark.high, double{mark.from}, double{mark.to}, double{mark.angle},
          double{mark.half}, double{mark.wide}, double{mark.tall}, double{mark.deep}})
      hash.add(v);
  }
}

}  // namespace effects
}  // namespace onggi
