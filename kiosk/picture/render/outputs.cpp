#include "kiosk/picture/render/outputs.h"

#include <algorithm>

namespace onggi::render {

namespace {

const Output* find(const Outputs& outputs, std::uint64_t id) {
  const auto at = std::find_if(outputs.all.begin(), outputs.all.end(),
                               [id](const Output& output) { return output.id == id; });
  return at == outputs.all.end() ? nullptr : &*at;
}

bool shows_what_it_can(const Output& output) {
  return output.mode != 0 &&
         std::find(output.modes.begin(), output.modes.end(), output.mode) != output.modes.end();
}

/// True if it was plugged in since `before`, or has another monitor.
bool is_new_monitor(const std::optional<Outputs>& before, const Outputs& now,
                    const Output& output) {
  if (!before)
    return std::none_of(now.all.begin(), now.all.end(),
                        [](const Output& other) { return other.connected && other.mode != 0; });
  const Output* was = find(*before, output.id);
  return was == nullptr || !was->connected ||
         (was->monitor != 0 && output.monitor != 0 && was->monitor != output.monitor);
}

}  // namespace

const Output* Outputs::shown_on() const {
  const Output* first = nullptr;
  const Output* lit = nullptr;
  for (const Output& output : all) {
    if (!output.connected) continue;
    if (output.id == primary) return &output;
    if (first == nullptr) first = &output;
    if (lit == nullptr && output.mode != 0) lit = &output;
  }
  return lit != nullptr ? lit : first;
}

Relighting relight(const std::optional<Outputs>& before, const Outputs& now) {
  const Output* on = now.shown_on();
  if (on == nullptr || on->modes.empty()) return {};
  const bool cannot = on->mode != 0 && !shows_what_it_can(*on);
  if (!cannot && !is_new_monitor(before, now, *on)) return {};
  Relighting change{.light = on->id, .mode = on->modes.front()};
  for (const Output& output : now.all)
    if (!output.connected && output.mode != 0) change.darken.push_back(output.id);
  if (on->mode == change.mode && change.darken.empty()) return {};
  return change;
}

std::array<float, 9> touch_map(const Outputs& outputs, const Output& on) {
  const auto whole_w = static_cast<float>(std::max(outputs.width, 1)),
             whole_h = static_cast<float>(std::max(outputs.height, 1));
  const float x = static_cast<float>(on.x) / whole_w, y = static_cast<float>(on.y) / whole_h;
  const float w = static_cast<float>(on.width) / whole_w,
              h = static_cast<float>(on.height) / whole_h;
  switch (on.turned) {
    case Output::Turned::left:
      return {0, -w, x + w, h, 0, y, 0, 0, 1};
    case Output::Turned::upside_down:
      return {-w, 0, x + w, 0, -h, y + h, 0, 0, 1};
    case Output::Turned::right:
      return {0, w, x, -h, 0, y + h, 0, 0, 1};
    case Output::Turned::upright:
      break;
  }
  return {w, 0, x, 0, h, y, 0, 0, 1};
}

}  // namespace onggi::render
