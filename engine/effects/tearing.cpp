#include "engine/effects/tearing.h"

#include <algorithm>

#include "engine/effects/effect_list.h"
#include "engine/effects/row_kernels.h"

namespace onggi::effects {
namespace {

constexpr double kRound = 0.1;     // s: every row can be checked within it
constexpr std::size_t kLumps = 4;  // lumps whose tears are kept for undo, at least

}  // namespace

Tearing::Tearing(Clay& clay)
    : unseen_(clay.room()),
      hollow_square_(clay.def().outer_radius * clay.def().outer_radius +
                     clay.def().inner_radius * clay.def().inner_radius),
      solid_square_(clay.def().outer_radius * clay.def().outer_radius),
      solid_rows_(clay.floor_rows()),
      lump_(static_cast<std::size_t>(clay.room()) + 1) {
  events_.reserve(kLumps * lump_);
  clay.areas()->keep_torn();
}

// A ring's girth is that of the circle that halves its clay: radius^2 = (outer^2 + inner^2) / 2. It
// stays when the clay only gets thicker or thinner, or when the ring lies off the axis.
bool Tearing::tears_now(const StageWork& work, int j) const noexcept {
  const Clay& clay = work.clay;
  const WallsDef& def = *work.def.walls;
  if (j < clay.floor_rows()) return false;
  const row_kernels::Ring ring =
      row_kernels::of(clay.vectors())
          .measure(clay.stride(), clay.outer(j).data(), clay.inner(j).data());
  if (double{ring.thinnest} < def.tear_thickness) return true;
  double laid = j < solid_rows_ ? solid_square_ : hollow_square_;
  double strength = 1.0;
  if (work.building != nullptr) {
    const int stored = clay.stored(j);
    strength = work.building->strength(*work.def.building, stored);
    if (const double square = work.building->laid_square(stored); square > 0.0) laid = square;
  }
  const double wider = 1.0 + strength * def.tear_strain;
  return def.tear_strain > 0.0 && double{ring.squares} > wider * wider * laid * clay.sectors();
}

void Tearing::note(Event event) noexcept {
  // Forget tears of old lumps. A lump that undo brings back is checked anew.
  if (events_.size() == kLumps * lump_)
    events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(lump_));
  if (!events_.empty()) event.step = std::max(event.step, events_.back().step);
  events_.push_back(event);
}

// Takes the next row in turn; -1 if none waits.
int Tearing::next_unseen() noexcept {
  int j = unseen_.take(next_);
  if (j < 0) j = unseen_.take();
  if (j >= 0) next_ = (j + 1) % unseen_.room();
  return j;
}

bool Tearing::wanted(const Effects& def) { return def.walls && tears(*def.walls); }

void Tearing::run(const StageWork& work) noexcept {
  Clay& clay = work.clay;
  RowAreas& areas = *clay.areas();
  // With volume, a later stage still asks which rows changed.
  areas.add_changed(unseen_, work.volume == nullptr);
  for (owed_ += clay.rows() * work.tick.seconds / kRound; owed_ >= 1.0; owed_ -= 1.0) {
    const int j = next_unseen();
    if (j < 0) {
      owed_ = 0.0;
      return;
    }
    if (j >= clay.rows()) continue;
    if (areas.torn(j) || !tears_now(work, j)) continue;
    areas.tear(j);
    ++torn_rows_;
    note({work.tick.step, clay.stored(j)});
    clay.mark_to_draw(j);
  }
}

void Tearing::row_divided(const Clay&, const RowDivided& divided) noexcept {
  const int j = divided.row;
  const bool unseen = unseen_.has(j);
  unseen_.open(j + 1);
  if (unseen) unseen_.add(j + 1);
}

void Tearing::rows_joined(const Clay&, const RowsJoined& joined) noexcept {
  const int j = joined.row;
  const bool unseen = unseen_.has(j + 1);
  unseen_.close(j + 1);
  if (unseen) unseen_.add(j);
}

void Tearing::lay(Clay& clay, std::uint64_t step) noexcept {
  note({step, kFreshLump});
  clay.areas()->mend();
  torn_rows_ = 0;
  unseen_.clear();
}

void Tearing::go_back(Clay& clay, std::uint64_t step) noexcept {
  RowAreas& areas = *clay.areas();
  while (!events_.empty() && events_.back().step >= step) events_.pop_back();
  for (int j = 0; j < clay.rows(); ++j)
    if (areas.torn(j)) clay.mark_to_draw(j);
  areas.mend();
  const auto lump = std::find_if(events_.rbegin(), events_.rend(), [](const Event& event) {
                      return event.row == kFreshLump;
                    }).base();
  // A row that came in the step taken back, and tore in it, counted with the step before
  // (Scene::State::work_on_rows). That row is gone now.
  events_.erase(std::remove_if(lump, events_.end(),
                               [&clay](const Event& event) {
                                 return clay.place_of(event.row) == RowOrder::kSpare;
                               }),
                events_.end());
  std::for_each(lump, events_.end(),
                [&](const Event& event) { areas.tear(clay.place_of(event.row)); });
  torn_rows_ = static_cast<int>(events_.end() - lump);
  for (int j = 0; j < clay.rows(); ++j) unseen_.add(j);
}

void Tearing::add_to(StateHash& hash, Clay& clay) const {
  unseen_.add_to(hash);
  for (int j = 0; j < clay.rows(); ++j)
    if (clay.areas()->torn(j)) hash.add(static_cast<std::uint64_t>(j));
  hash.add(static_cast<std::uint64_t>(next_));
  hash.add(owed_);
  hash.add(static_cast<std::uint64_t>(events_.size()));
}

}  // namespace onggi::effects
