#include "kiosk/visit/sound/ear.h"

#include <string_view>

namespace onggi::sound {

namespace {

Rub::Kind kind_of(std::string_view tool) {
  if (tool == "sponge") return Rub::Kind::sponge;
  if (tool == "wire") return Rub::Kind::wire;
  // Tools with a handle and an edge.
  if (tool.ends_with("rib") || tool == "loop_trimmer" || tool == "needle") return Rub::Kind::rib;
  return Rub::Kind::hand;
}

}  // namespace

Heard hear(const loop::LoopStatus& status) noexcept {
  Heard out;
  if (status.shown) return out;
  out.wheel = status.feedback.wheel_speed;
  out.wet = status.feedback.wetness;
  for (std::size_t i = 0; i < out.rub.size(); ++i) {
    const HandFeedback& felt = status.feedback.hand[i];
    if (!felt.contact) continue;
    out.rub[i] = {kind_of(status.hand[i].name), length(felt.touch.clay), length(felt.touch.push)};
  }
  return out;
}

}  // namespace onggi::sound
