#include "kiosk/visit/screens/focus.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace onggi::screens {

namespace {
constexpr float kAnotherRow = 1e5f;  // pixels: farther than anything on a screen
}  // namespace

std::string step_focus(const std::vector<Control>& controls, const std::string& from,
                       Direction direction) {
  if (controls.empty()) return {};
  const auto at = std::find_if(controls.begin(), controls.end(),
                               [&](const Control& c) { return c.id == from; });
  if (at == controls.end()) return controls.front().id;

  const auto centre = [](const view::Rect& r) { return std::pair(r.x + r.w / 2, r.y + r.h / 2); };
  const auto [x0, y0] = centre(at->rect);
  const Control* nearest = nullptr;
  float least = std::numeric_limits<float>::max();
  for (const Control& c : controls) {
    if (&c == &*at) continue;
    const auto [x, y] = centre(c.rect);
    float along = 0, across = 0;
    switch (direction) {
      case Direction::up:
        along = y0 - y, across = x - x0;
        break;
      case Direction::down:
        along = y - y0, across = x - x0;
        break;
      case Direction::left:
        along = x0 - x, across = y - y0;
        break;
      case Direction::right:
        along = x - x0, across = y - y0;
        break;
    }
    if (along < 2.0f) continue;
    // Left and right stay in the row while it has another control there.
    const bool level = direction == Direction::left || direction == Direction::right;
    const bool elsewhere = level && std::abs(across) > 0.25f * (at->rect.h + c.rect.h);
    const float cost = along + 2.0f * std::abs(across) + (elsewhere ? kAnotherRow : 0.0f);
    if (cost < least) least = cost, nearest = &c;
  }
  if (nearest) return nearest->id;

  const std::size_t n = controls.size();
  const auto i = static_cast<std::size_t>(at - controls.begin());
  const bool onward = direction == Direction::right || direction == Direction::down;
  return controls[onward ? (i + 1) % n : (i + n - 1) % n].id;
}

std::vector<std::vector<std::size_t>> rows_of(const std::vector<Control>& all, bool right_to_left) {
  const auto middle = [&](std::size_t i) { return all[i].rect.y + all[i].rect.h / 2; };
  std::vector<std::size_t> order(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return middle(a) < middle(b); });
  std::vector<std::vector<std::size_t>> rows;
  for (const std::size_t i : order) {
    const bool level =
        !rows.empty() && std::abs(middle(i) - middle(rows.back().front())) <
                             0.5f * std::min(all[i].rect.h, all[rows.back().front()].rect.h);
    if (!level) rows.emplace_back();
    rows.back().push_back(i);
  }
  for (auto& row : rows)
    std::stable_sort(row.begin(), row.end(), [&](std::size_t a, std::size_t b) {
      return right_to_left ? all[a].rect.x > all[b].rect.x : all[a].rect.x < all[b].rect.x;
    });
  return rows;
}

std::vector<Control> in_reading_order(const std::vector<Control>& controls, bool right_to_left) {
  std::vector<Control> out;
  for (const auto& row : rows_of(controls, right_to_left))
    for (const std::size_t i : row) out.push_back(controls[i]);
  return out;
}

}  // namespace onggi::screens
