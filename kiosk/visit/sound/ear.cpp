#include "kiosk/visit/sound/ear.h"

#include <string_view>

#include "engine/contact/tool.h"

namespace onggi::sound {

namespace {

Rub::Kind kind_of(std::string_view tool) {
  const ToolShape* const shape = find_tool_shape(tool);
  switch (shape != nullptr ? shape->material : ToolMaterial::skin) {
    case ToolMaterial::sponge:
      return Rub::Kind::sponge;
    case ToolMaterial::edge:
      return Rub::Kind::rib;
    case ToolMaterial::wire:
      return Rub::Kind::wire;
    case ToolMaterial::skin:
      break;
  }
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
    out.knock[i].force = felt.blow;
    if (!felt.contact) continue;
    out.rub[i] = {kind_of(status.hand[i].name), length(felt.touch.clay), length(felt.touch.push)};
  }
  return out;
}

}  // namespace onggi::sound
