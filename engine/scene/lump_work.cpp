#include "engine/scene/lump_work.h"

#include <array>

#include "engine/clay/row_division.h"

namespace onggi::scene {
namespace {

constexpr int kBudget = 8192;  // elements a tick

std::uint64_t depth_of(const clay::History* history) { return history ? history->depth() : 0; }

enum class Part : std::uint8_t { none, history, effects };
enum class HistoryThen : std::uint8_t {
  follows,  // as usual
  busy,     // follows, and the step continues during the work on the lump
  waits,    // waits until the work on the lump is done
};

}  // namespace

// A row of the state table: the next state for each event, the work in a tick and the part it
// needs, and what the history does meanwhile.
struct LumpWork::Row {
  std::array<LumpState, 3> after;                       // by LumpEvent
  bool (LumpWork::*work)(const Parts&) const noexcept;  // true when done; null: no work
  Part with;
  HistoryThen history;
};

const LumpWork::Row& LumpWork::row_of(LumpState state) noexcept {
  using enum LumpState;
  using enum HistoryThen;
  static constexpr std::array<Row, kLumpStates> kRows{{
      // on renew, restore, done
      {{keeping, restoring, playing}, nullptr, Part::none, follows},                 // playing
      {{keeping, keeping, renewing}, &LumpWork::keep, Part::history, waits},         // keeping
      {{renewing, renewing, laying}, &LumpWork::renew, Part::none, busy},            // renewing
      {{laying, laying, playing}, &LumpWork::lay, Part::effects, busy},              // laying
      {{restoring, restoring, settling}, &LumpWork::restore, Part::history, waits},  // restoring
      {{settling, settling, playing}, &LumpWork::settle, Part::effects, follows},    // settling
  }};
  return kRows[static_cast<std::size_t>(state)];
}

LumpState after(LumpState state, LumpEvent event) noexcept {
  return LumpWork::row_of(state).after[static_cast<std::size_t>(event)];
}

bool LumpWork::keep(const Parts& parts) const noexcept {
  return parts.history->begin_step(parts.clay, kBudget);
}

bool LumpWork::renew(const Parts& parts) const noexcept {
  // Extra rows leave at the top before anything is laid.
  if (!clay::restore_row_count(parts.clay, parts.history, kBudget)) return false;
  return parts.clay.renew_some(kBudget);
}

bool LumpWork::lay(const Parts& parts) const noexcept {
  if (parts.moisture != nullptr) parts.moisture->count_rows(parts.clay);
  return parts.row_effects->settle_some(parts.def, parts.clay, {true, depth_of(parts.history)},
                                        kBudget);
}

bool LumpWork::restore(const Parts& parts) const noexcept {
  clay::History& history = *parts.history;
  if (!history.step_back_some(parts.clay, kBudget)) return false;
  if (parts.row_effects == nullptr || !history.can_step_back()) return true;
  // Undo goes back to where a fallen pot last stood, or to before the tear, even if the pot has
  // sagged since.
  const RowEffects& effects = *parts.row_effects;
  const bool falling = effects.fallen() && history.depth() > stood_at_;
  return !falling && !effects.torn_before(history.depth());
}

bool LumpWork::settle(const Parts& parts) const noexcept {
  if (parts.moisture != nullptr) parts.moisture->count_rows(parts.clay);
  return parts.row_effects->settle_some(parts.def, parts.clay, {false, depth_of(parts.history)},
                                        kBudget);
}

void LumpWork::go(LumpEvent event, const Parts& parts) noexcept {
  const auto there = [&parts](Part part) {
    return part == Part::none ||
           (part == Part::history ? parts.history != nullptr : parts.row_effects != nullptr);
  };
  state_ = after(state_, event);
  while (!there(row_of(state_).with)) state_ = after(state_, LumpEvent::done);
}

bool LumpWork::step(const Hands& hands, const Parts& parts) noexcept {
  const bool renew = hands.renew && !renew_held_;
  const bool restore = hands.restore && !restore_held_;
  renew_held_ = hands.renew;
  restore_held_ = hands.restore;
  if (renew)
    go(LumpEvent::renew, parts);
  else if (restore && parts.history != nullptr && parts.history->can_step_back())
    go(LumpEvent::restore, parts);
  const Row& now = row_of(state_);
  if (now.work == nullptr) return false;
  if ((this->*now.work)(parts)) go(LumpEvent::done, parts);
  note_step(parts);
  return true;
}

void LumpWork::note_step(const Parts& parts) noexcept {
  const std::uint64_t step = depth_of(parts.history);
  if (step > step_ && parts.row_effects != nullptr) parts.row_effects->note_step(parts.clay, step);
  step_ = step;
}

void LumpWork::follow(const Parts& parts, bool touching, double seconds) noexcept {
  const HistoryThen does = row_of(state_).history;
  if (parts.history == nullptr || does == HistoryThen::waits) return;
  using Stir = clay::History::Stir;
  Stir stir = touching || does == HistoryThen::busy ? Stir::touching : Stir::none;
  if (parts.row_effects != nullptr) {
    if (stir == Stir::none && parts.row_effects->moving()) stir = Stir::moving;
    // All rows of a ring come in one step, or undo would leave a part of it.
    if (parts.row_effects->rises()) stir = Stir::touching, seconds = 0.0;
    if (parts.row_effects->stands()) stood_at_ = parts.history->depth();
  }
  parts.history->follow(parts.clay, stir, seconds);
  note_step(parts);
}

}  // namespace onggi::scene
