#include "engine/scene/row_effects.h"

#include <algorithm>
#include <type_traits>

#include "engine/clay/row_division.h"
#include "engine/effects/built.h"

namespace onggi::scene {
namespace {

using effects::Stages;

static_assert(effects::kMostHands == kMaxHands);

template <class... S>
bool any_wanted(Stages<S...>, const Effects& def) {
  return (S::wanted(def) || ...);
}

template <class... S>
bool any_asks_moves(Stages<S...>, const Effects& def) {
  return ((S::kAsksMoves && S::wanted(def)) || ...);
}

template <class S>
constexpr bool kLays = requires(const Effects& def, Clay& clay) {
  S::lay_row(def, clay, 0);
};

template <class... S>
bool any_lays(Stages<S...>, const Effects& def) {
  return ((kLays<S> && S::wanted(def)) || ...);
}

template <class... S>
void lay_row(Stages<S...>, const Effects& def, Clay& clay, int j) {
  const auto lay = [&]<class One>(std::type_identity<One>) {
    if constexpr (kLays<One>)
      if (One::wanted(def)) One::lay_row(def, clay, j);
  };
  (lay(std::type_identity<S>{}), ...);
}

// Kept hashes depend on this order of the first stages.
using HashedFirst =
    Stages<effects::Volume, effects::Slump, effects::Springback, effects::Wobble, effects::Tearing>;

template <class One, class... S>
constexpr bool among(Stages<S...>) {
  return (std::is_same_v<One, S> || ...);
}

constexpr effects::RowStages kStages;

}  // namespace

// Calls `visit` with each stage that is present, in order.
template <class Visit>
void RowEffects::each(Visit&& visit) {
  std::apply([&](auto&... stage) { ((stage ? visit(*stage) : void()), ...); }, stages_);
}

effects::Volume* RowEffects::volume() {
  auto& volume = std::get<std::optional<effects::Volume>>(stages_);
  return volume ? &*volume : nullptr;
}

effects::Building* RowEffects::building() {
  auto& building = std::get<std::optional<effects::Building>>(stages_);
  return building ? &*building : nullptr;
}

effects::Prints* RowEffects::prints() {
  auto& prints = std::get<std::optional<effects::Prints>>(stages_);
  return prints ? &*prints : nullptr;
}

std::vector<Print> RowEffects::prints(const Clay& clay) const {
  const auto& prints = stage<effects::Prints>();
  const auto& volume = stage<effects::Volume>();
  return prints && volume ? prints->seen(clay, *volume) : std::vector<Print>();
}

int RowEffects::spare_rows(const SceneDef& def) {
  if (!effects::kBuilt || !def.volume) return 0;
  const int coils = def.building ? effects::Building::spare_rows(*def.building, def.clay) : 0;
  return effects::Refinement::spare_rows(def.clay) + coils;
}

bool RowEffects::lay(const Effects& def, Clay& clay, Vec3 from, Vec3 to, double seconds,
                     std::uint64_t step) noexcept {
  return building()->lay(*def.building, clay, from, to, seconds, step);
}

std::unique_ptr<RowEffects> RowEffects::make(const Effects& def, Clay& clay) {
  if (!effects::kBuilt) return nullptr;
  if (!def.walls && !any_wanted(kStages, def)) return nullptr;
  auto present = std::make_unique<RowEffects>();
  if (any_lays(kStages, def))
    for (int j = 0; j < clay.rows(); ++j) lay_row(kStages, def, clay, j);
  const bool asks_moves = any_asks_moves(kStages, def);
  if (def.walls || asks_moves) clay.keep_areas();
  if (asks_moves) clay.keep_displacements(def.smoothing.has_value());
  const auto make = [&]<class S>(std::optional<S>& stage) {
    if (S::wanted(def)) stage.emplace(S::make(def, clay));
  };
  std::apply([&](auto&... stage) { (make(stage), ...); }, present->stages_);
  return present;
}

double RowEffects::along(const Effects& def, Vec3 pressing, const Vec3* holding) const noexcept {
  if (!def.walls) return 0.0;
  return holding == nullptr ? 1.0 : 1.0 - effects::wall_support(*def.walls, pressing, *holding);
}

void RowEffects::run(const Effects& def, Clay& clay, const Tick& tick) noexcept {
  for (std::size_t n = 0; n < tick.hand.size(); ++n)
    since_touch_[n] =
        tick.hand[n].normal > 0.0 ? 0.0 : std::min(since_touch_[n] + tick.seconds, 1.0);
  const bool asks_moves = clay.displacements(false) != nullptr;
  if (asks_moves) take_turn(clay, tick.seconds);
  // 6.1 to 6.10
  const effects::StageWork work{def,        clay,          tick,     volume(), building(),
                                turn_.side, turn_.seconds, settled_, prints()};
  each([&](auto& stage) { stage.run(work); });
  // 6.11, 6.12
  if (building() != nullptr) add_coil(def, clay, tick);
  if (work.volume != nullptr) refine(clay, tick);
  if (asks_moves)
    if (Displacements& moved = *clay.displacements(turn_.side == WallSide::inside); moved.any())
      moved.clear(clay.stored());
  settled_ = false;
}

// If both faces were pressed, they take turns, one a tick. This halves the work; at 500 Hz nobody
// feels the difference.
void RowEffects::take_turn(Clay& clay, double seconds) noexcept {
  const bool outside = clay.displacements(false)->any();
  const bool inside = clay.displacements(true)->any();
  if (outside && inside)
    turn_ = {turn_.side == WallSide::outside ? WallSide::inside : WallSide::outside, 2.0 * seconds};
  else
    turn_ = {inside ? WallSide::inside : WallSide::outside, seconds};
}

// As much as the lump's renewal takes in a tick, and at least a row.
void RowEffects::add_coil(const Effects& def, Clay& clay, const Tick& tick) noexcept {
  constexpr int kElementsATick = 8192;
  effects::Building& coil = *building();
  if (!coil.rises()) return;
  const int first = clay.rows();
  double all = tick.moisture != nullptr ? volume()->of_all(clay) : 0.0;
  const std::uint64_t step = tick.history != nullptr ? tick.history->depth() : 0;
  for (int n = std::max(1, kElementsATick / clay.stride());
       n > 0 && coil.rises() && clay.spare_rows() > 0; --n) {
    if (tick.history != nullptr) {
      tick.history->keep_row(clay, clay.next_spare());
      tick.history->note_inserted(clay.rows());
    }
    const effects::RowAdded added = coil.raise(*def.building, clay, step);
    each([&](auto& stage) { stage.row_added(clay, added); });
    all += added.volume;
    if (tick.moisture != nullptr)
      tick.moisture->row_added(clay, added.to, def.building->wetness, added.volume / all);
  }
  clay.restack_divided(first);
}

// Few changes a tick, because each costs a row's elements and moves all rows above.
void RowEffects::refine(Clay& clay, const Tick& tick) noexcept {
  using Kind = effects::Refinement::Change::Kind;
  // A ring under way has its rows.
  if (building() != nullptr && building()->rows_kept() > 0 &&
      clay.spare_rows() < building()->rows_kept() + effects::Refinement::kMostChanges)
    return;
  for (int n = 0; n < effects::Refinement::kMostChanges; ++n) {
    const effects::Refinement::Change change = refinement_.next(clay, *volume());
    if (change.kind == Kind::none) return;
    change.kind == Kind::divide ? divide(clay, change.row, tick) : join(clay, change.row, tick);
  }
}

void RowEffects::divide(Clay& clay, int j, const Tick& tick) noexcept {
  const effects::RowDivided divided{j, clay.stored(j), clay.next_spare()};
  if (tick.history != nullptr) {
    for (const int row : {divided.from, divided.to}) tick.history->keep_row(clay, row);
    tick.history->note_inserted(j + 1);
  }
  clay::divide_row(clay, j, volume()->of_row(j));
  each([&](auto& stage) { stage.row_divided(clay, divided); });
  if (tick.moisture != nullptr) tick.moisture->row_divided(clay, divided.from, divided.to);
}

void RowEffects::join(Clay& clay, int j, const Tick& tick) noexcept {
  const double upper = volume()->of_row(j + 1);
  const double both = volume()->of_row(j) + upper;
  const effects::RowsJoined joined{j, clay.stored(j), clay.stored(j + 1), upper};
  bool loaded = false;
  each([&](const auto& stage) {
    if constexpr (requires { stage.loaded(0); })
      loaded = loaded || stage.loaded(joined.from) || stage.loaded(joined.to);
  });
  if (loaded) return;
  if (tick.history != nullptr) {
    for (const int row : {joined.from, joined.to}) tick.history->keep_row(clay, row);
    tick.history->note_erased(j + 1, j + 1 < clay.floor_rows());
  }
  clay::join_rows(clay, j, both);
  each([&](auto& stage) { stage.rows_joined(clay, joined); });
  if (tick.moisture != nullptr)
    tick.moisture->rows_joined(clay, joined.from, joined.to, upper / both);
}

bool RowEffects::settle_some(const Effects& def, Clay& clay, const effects::Laid& laid,
                             int element_budget) noexcept {
  if (laid.fresh && laid_to_ < clay.rows() && any_lays(kStages, def)) {
    const int some = std::max(1, element_budget / clay.stride());
    for (const int end = std::min(clay.rows(), laid_to_ + some); laid_to_ < end; ++laid_to_)
      lay_row(kStages, def, clay, laid_to_);
    return false;
  }
  bool measured = true;
  each([&](auto& stage) {
    if constexpr (requires { stage.measure_some(clay, element_budget); })
      measured = measured && stage.measure_some(clay, element_budget);
  });
  if (!measured) return false;
  each([&](auto& stage) { stage.forget(clay, laid); });
  clay.forget_displacements();
  laid_to_ = 0;
  since_touch_.fill(1.0);
  settled_ = true;
  return true;
}

void RowEffects::note_step(const Clay& clay, std::uint64_t step) noexcept {
  if (volume() != nullptr) volume()->note_step(clay, step);
}

void RowEffects::add_to(StateHash& hash, Clay& clay) const {
  const auto add = [&]<class S>(const std::optional<S>& stage) {
    if (stage) stage->add_to(hash, clay);
    if constexpr (std::is_same_v<S, effects::Volume>)
      if (stage) refinement_.add_to(hash);
  };
  const auto add_first = [&]<class... S>(Stages<S...>) { (add(stage<S>()), ...); };
  add_first(HashedFirst{});
  const auto add_later = [&]<class S>(const std::optional<S>& stage) {
    if constexpr (!among<S>(HashedFirst{})) add(stage);
  };
  std::apply([&](const auto&... stage) { (add_later(stage), ...); }, stages_);
  for (double since : since_touch_) hash.add(since);
  hash.add(static_cast<std::uint64_t>(laid_to_) << 1 | (turn_.side == WallSide::inside ? 1 : 0));
}

}  // namespace onggi::scene
