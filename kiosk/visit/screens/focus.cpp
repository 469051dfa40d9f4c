#include "kiosk/visit/screens/focus.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace onggi::screens {

namespace {
constexpr float kAnotherRow = 1e5f;  // pixels: farther than anything on a screen
constexpr float kEqual = 1e-3f;      // centres decide between controls that are equally near

/// What a rectangle covers of one axis.
struct Span {
  float begin = 0, length = 0;
  float middle() const { return begin + length / 2; }
};
Span span(const view::Rect& r, bool upright) { return upright ? Span{r.y, r.h} : Span{r.x, r.w}; }
/// From edge to edge; negative where they overlap.
float apart(const Span& a, const Span& b) {
  return std::max(a.begin - b.begin - b.length, b.begin - a.begin - a.length);
}
}  // namespace

std::string step_focus(const std::vector<Control>& controls, const std::string& from,
                       Direction direction) {
  if (controls.empty()) return {};
  const auto at = std::find_if(controls.begin(), controls.end(),
                               [&](const Control& c) { return c.id == from; });
  if (at == controls.end()) return controls.front().id;

  const bool upright = direction == Direction::up || direction == Direction::down;
  const bool forward = direction == Direction::down || direction == Direction::right;
  const Control* nearest = nullptr;
  float least = std::numeric_limits<float>::max();
  for (const Control& c : controls) {
    if (&c == &*at) continue;
    const Span here = span(at->rect, upright), to = span(c.rect, upright);
    const float centres = forward ? to.middle() - here.middle() : here.middle() - to.middle();
    if (centres < 2.0f) continue;
    const Span beside = span(at->rect, !upright), there = span(c.rect, !upright);
    // Edges count, not centres: else a wide control hides a narrow one right beside it.
    const float across = std::max(0.0f, apart(beside, there));
    const bool passes = -apart(here, to) > 0.5f * std::min(here.length, to.length);
    // Left and right stay in the row while it has another control there. Up and down leave it.
    const bool elsewhere = upright ? passes : across > 0;
    const float cost = std::max(0.0f, apart(here, to)) + across +
                       kEqual * std::abs(beside.middle() - there.middle()) +
                       (elsewhere ? kAnotherRow : 0.0f);
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
