#include "kiosk/program/commands/posted_state.h"

#include "kiosk/ground/files/log.h"
#include "kiosk/ground/files/wall_clock.h"

namespace onggi::commands {

namespace {

constexpr double kEvery = 1.0;  // s between two states

}  // namespace

void count_frame(exhibit::Kiosk& kiosk, watch::Health& health) {
  const loop::LoopStatus status = kiosk.wheel_host().status();
  const exhibit::Doing doing = kiosk.doing();
  ++health.frames;
  health.wakes = status.deadlines.wakes;
  health.late = status.deadlines.late;
  health.overruns = status.deadlines.overruns;
  health.lost_ticks = status.deadlines.lost_ticks;
  health.worst_wake_s = 1e-6 * status.deadlines.worst_wake_us;
  health.dark = doing.dark;
  health.kept = doing.saved.kept;
  health.not_kept = doing.saved.refused;
  const auto room = doing.room.value_or(souvenir::Room{});
  health.promised_bytes = room.promised;
  health.quota_bytes = room.quota;
}

void PostedState::shows(const exhibit::Kiosk& kiosk, const std::filesystem::path& config,
                        bool stands_in) {
  std::error_code error;
  const std::filesystem::path& keepsakes = kiosk.doing().keepsake_folder;
  if (!board_ || keepsakes != keepsakes_)
    board_ = std::make_unique<watch::StateBoard>(keepsakes_ = keepsakes);
  state_ = {};
  began_ = -1.0, told_ = -1e9;
  frames_told_ = 0;
  state_.health.version = ONGGI_VERSION;
  state_.exhibit = std::filesystem::absolute(config, error).lexically_normal().string();
  state_.stands_in = stands_in;
}

void PostedState::look(exhibit::Kiosk& kiosk, double now) {
  count_frame(kiosk, state_.health);
  if (now - told_ < kEvery) return;
  const exhibit::Doing doing = kiosk.doing();
  if (began_ < 0.0) began_ = now;
  state_.frames_a_second = static_cast<double>(state_.health.frames - frames_told_) / (now - told_);
  frames_told_ = state_.health.frames;
  told_ = now;
  state_.said = files::wall_now();
  state_.health.running_s = now - began_;
  state_.open = doing.open_to_visitors;
  state_.visitor = state_.open && !doing.nobody_is_here && !doing.dark;
  const screens::ShelfCard* card = kiosk.card(doing.card);
  state_.vessel = card != nullptr && card->vessel != nullptr ? card->vessel->id : "";
  state_.devices = kiosk.plugged_in();
  if (doing.way_in) {
    state_.way_in = doing.way_in->digest;
    state_.way_in_until = doing.way_in->until;
  }
  state_.trouble = files::last_trouble();
  board_->show(state_);
}

}  // namespace onggi::commands
