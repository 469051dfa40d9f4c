#include "engine/scene/row_effects.h"

#include <algorithm>

#include "engine/clay/row_division.h"
#include "engine/effects/built.h"

namespace onggi::scene {
namespace {

// Moved by no press of its own, a face moves the wall as the hand on it does, and as one that
// nobody holds where there is no hand.
double along_of(const SceneDef& def, const RowEffects::Tick& tick, WallSide side) {
  double along = def.walls ? 1.0 : 0.0;
  for (const RowEffects::HandThere& hand : tick.hand)
    if (hand.on_wall && hand.side == side) along = std::min(along, hand.along);
  return along;
}

}  // namespace

int RowEffects::spare_rows(const SceneDef& def) {
  return effects::kBuilt && def.volume ? effects::Refinement::spare_rows(def.clay) : 0;
}

std::unique_ptr<RowEffects> RowEffects::make(const SceneDef& def, Clay& clay) {
  if (!effects::kBuilt) return nullptr;
  if (!def.walls && !def.propagation && !def.springback && !def.smoothing && !def.wobble &&
      !def.slump && !def.volume)
    return nullptr;
  auto present = std::make_unique<RowEffects>();
  RowEffects& e = *present;
  if (def.wobble)
    for (int j = 0; j < clay.rows(); ++j)
      effects::lay_off_centre(clay, j, {def.wobble->off_centre, 0.0});
  const bool about_contact = def.propagation || def.springback || def.smoothing;
  if (def.walls || about_contact) clay.keep_areas();
  if (about_contact) clay.keep_displacements();
  // 6.1
  if (def.propagation) {
    e.propagation_.emplace(clay.room());
    e.stages_.push_back(&RowEffects::drag_neighbours);
  }
  // 6.2
  if (def.springback) {
    e.springback_.emplace(clay);
    e.stages_.push_back(&RowEffects::spring_back);
  }
  // 6.3
  if (def.smoothing) {
    e.smoothing_.emplace(clay.room());
    e.stages_.push_back(&RowEffects::smooth);
  }
  // 6.4
  if (def.wobble) {
    e.wobble_.emplace();
    e.stages_.push_back(&RowEffects::centre);
  }
  // 6.5
  if (def.slump) {
    e.slump_.emplace(clay.room());
    e.stages_.push_back(&RowEffects::sink);
  }
  // 6.6
  if (def.walls && effects::tears(*def.walls)) {
    e.tearing_.emplace(clay);
    e.stages_.push_back(&RowEffects::tear);
  }
  // 6.7
  if (def.volume) {
    e.volume_.emplace(clay);
    e.stages_.push_back(&RowEffects::keep_volume);
    // 6.8
    e.stages_.push_back(&RowEffects::refine);
  }
  if (about_contact) e.stages_.push_back(&RowEffects::clear_shifts);
  return present;
}

double RowEffects::along(const SceneDef& def, Vec3 pressing, const Vec3* holding) const noexcept {
  if (!def.walls) return 0.0;
  return holding == nullptr ? 1.0 : 1.0 - effects::wall_support(*def.walls, pressing, *holding);
}

void RowEffects::run(const SceneDef& def, Clay& clay, const Tick& tick) noexcept {
  for (std::size_t n = 0; n < tick.hand.size(); ++n)
    since_touch_[n] =
        tick.hand[n].normal > 0.0 ? 0.0 : std::min(since_touch_[n] + tick.seconds, 1.0);
  if (clay.displacements(false) != nullptr) take_turn(clay, tick.seconds);
  for (const Stage stage : stages_) (this->*stage)(def, clay, tick);
  settled_ = false;
}

// Where both faces were pressed, they take turns: what contact did to the other waits for the next
// tick. Half the work, and at 500 Hz nobody feels the difference.
void RowEffects::take_turn(Clay& clay, double seconds) noexcept {
  const bool outside = clay.displacements(false)->any();
  const bool inside = clay.displacements(true)->any();
  if (outside && inside)
    turn_ = {turn_.side == WallSide::outside ? WallSide::inside : WallSide::outside, 2.0 * seconds};
  else
    turn_ = {inside ? WallSide::inside : WallSide::outside, seconds};
}

void RowEffects::drag_neighbours(const SceneDef& def, Clay& clay, const Tick& tick) noexcept {
  propagation_->drag(*def.propagation, clay, turn_.side, along_of(def, tick, turn_.side));
}

void RowEffects::spring_back(const SceneDef& def, Clay& clay, const Tick& tick) noexcept {
  springback_->load(*def.springback, clay, turn_.side);
  springback_->come_back(*def.springback, clay, tick.seconds, def.walls ? 1.0 : 0.0);
}

void RowEffects::smooth(const SceneDef& def, Clay& clay, const Tick& tick) noexcept {
  for (const HandThere& hand : tick.hand)
    if (hand.on_wall && hand.smooths > 0.0 && hand.side == turn_.side)
      smoothing_->even(*def.smoothing, clay, hand.side, hand.at.y - hand.smooths,
                       hand.at.y + hand.smooths, turn_.seconds);
}

void RowEffects::centre(const SceneDef& def, Clay& clay, const Tick& tick) noexcept {
  static_assert(effects::Wobble::kMostHands == kMaxHands);
  for (std::size_t n = 0; n < tick.hand.size(); ++n)
    if (const HandThere& hand = tick.hand[n]; hand.on_wall)
      wobble_->press(n, {hand.at, hand.normal, hand.side}, tick.seconds);
  wobble_->centre(*def.wobble, clay, tick.seconds);
}

void RowEffects::sink(const SceneDef& def, Clay& clay, const Tick& tick) noexcept {
  const MoistureDef* moisture = def.moisture ? &*def.moisture : nullptr;
  slump_->sink(*def.slump, clay, *volume_,
               {tick.moisture, moisture, tick.wheel_speed, tick.seconds, tick.touched || settled_});
}

void RowEffects::tear(const SceneDef& def, Clay& clay, const Tick& tick) noexcept {
  tearing_->look(*def.walls, clay, tick.seconds, tick.step, !volume_);
}

void RowEffects::keep_volume(const SceneDef&, Clay& clay, const Tick& tick) noexcept {
  volume_->keep(clay, tick.seconds);
}

// Few changes a tick, since each costs a row's elements, and the places of all rows above it.
void RowEffects::refine(const SceneDef&, Clay& clay, const Tick& tick) noexcept {
  using Kind = effects::Refinement::Change::Kind;
  for (int n = 0; n < effects::Refinement::kMostChanges; ++n) {
    const effects::Refinement::Change change = refinement_.next(clay, *volume_);
    if (change.kind == Kind::none) return;
    change.kind == Kind::divide ? divide(clay, change.row, tick) : join(clay, change.row, tick);
  }
}

void RowEffects::divide(Clay& clay, int j, const Tick& tick) noexcept {
  const int from = clay.stored(j);
  const int to = clay.next_spare();
  if (tick.history != nullptr) {
    for (const int row : {from, to}) tick.history->keep_row(clay, row);
    tick.history->note_inserted(j + 1);
  }
  clay::divide_row(clay, j, volume_->of_row(j));
  volume_->row_divided(clay, j);
  if (tick.moisture != nullptr) tick.moisture->row_divided(clay, from, to);
  if (springback_) springback_->row_divided(from, to);
  if (wobble_) wobble_->row_divided(j);
  if (slump_) slump_->row_divided(j);
  if (tearing_) tearing_->row_divided(j);
}

void RowEffects::join(Clay& clay, int j, const Tick& tick) noexcept {
  const int from = clay.stored(j);
  const int to = clay.stored(j + 1);
  if (springback_ && (springback_->loaded(from) || springback_->loaded(to))) return;
  if (tick.history != nullptr) {
    for (const int row : {from, to}) tick.history->keep_row(clay, row);
    tick.history->note_erased(j + 1, j + 1 < clay.floor_rows());
  }
  const double upper = volume_->of_row(j + 1);
  const double both = volume_->of_row(j) + upper;
  clay::join_rows(clay, j, both);
  volume_->rows_joined(clay, j);
  if (tick.moisture != nullptr) tick.moisture->rows_joined(clay, from, to, upper / both);
  if (wobble_) wobble_->rows_joined(j);
  if (slump_) slump_->rows_joined(j, upper);
  if (tearing_) tearing_->rows_joined(j);
}

void RowEffects::clear_shifts(const SceneDef&, Clay& clay, const Tick&) noexcept {
  if (Displacements& displacements = *clay.displacements(turn_.side == WallSide::inside);
      displacements.any())
    displacements.clear(clay.stored());
}

bool RowEffects::settle_some(const SceneDef& def, Clay& clay, bool fresh, std::uint64_t step,
                             int element_budget) noexcept {
  if (def.wobble && fresh && laid_to_ < clay.rows()) {
    const int some = std::max(1, element_budget / clay.stride());
    for (const int end = std::min(clay.rows(), laid_to_ + some); laid_to_ < end; ++laid_to_)
      effects::lay_off_centre(clay, laid_to_, {def.wobble->off_centre, 0.0});
    return false;
  }
  if (volume_ && !volume_->measure_some(clay, element_budget)) return false;
  if (volume_ && !fresh) volume_->return_to(clay, step);
  if (springback_) springback_->forget();
  if (wobble_) wobble_->forget();
  clay.forget_displacements();
  if (slump_) slump_->forget_fall();
  if (tearing_ && fresh) tearing_->lay(clay, step);
  if (tearing_ && !fresh) tearing_->go_back(clay, step);
  laid_to_ = 0;
  since_touch_.fill(1.0);
  settled_ = true;
  return true;
}

void RowEffects::add_to(StateHash& hash, Clay& clay) const {
  if (volume_) {
    volume_->add_to(hash, clay);
    refinement_.add_to(hash);
  }
  if (slump_) slump_->add_to(hash, clay);
  if (springback_) springback_->add_to(hash);
  if (wobble_) wobble_->add_to(hash);
  if (tearing_) tearing_->add_to(hash, clay);
  for (double since : since_touch_) hash.add(since);
  hash.add(static_cast<std::uint64_t>(laid_to_) << 1 | (turn_.side == WallSide::inside ? 1 : 0));
}

}  // namespace onggi::scene
