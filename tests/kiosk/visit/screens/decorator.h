#pragma once

#include <cmath>
#include <optional>

#include "kiosk/picture/view/palette.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens {

/// A visitor whose pot is thrown, and may be decorated.
struct Decorator : Visitor {
  explicit Decorator(const std::string& way_id = "celadon",
                     const view::TextMeasure* measure = nullptr)
      : Visitor(2, measure, true) {
    offer(way_id);
    make_result();
  }
  const decorating::DecoratedPot* pot() const { return visit->decorated_pot(); }
  /// The middle of the pot's picture.
  std::pair<float, float> middle() const {
    const view::Rect mark = *visit->control("decorate.mark");
    return {mark.x + mark.w / 2, mark.y + mark.h * 0.55f};
  }
  void finger(int number, view::InputEvent::Kind kind, float x, float y) {
    view::InputEvent e;
    e.kind = kind, e.x = x, e.y = y, e.glass = true;
    e.finger = static_cast<std::uint8_t>(number);
    visit->input(e, now);
  }
  /// The box round words that stand in the frame; nothing where they do not.
  std::optional<view::Rect> box_of(const std::string& words) const {
    for (std::size_t n = 1; n < frame.items.size(); ++n)
      if (const auto* text = std::get_if<view::Text>(&frame.items[n]);
          text != nullptr && text->text == words)
        if (const auto* box = std::get_if<view::Box>(&frame.items[n - 1])) return box->rect;
    return std::nullopt;
  }
  /// Of the pot's outside, as it is seen.
  bool covers_pot(const view::Rect& box) const {
    const auto& surface = pot()->surface();
    for (int row = 0; row < surface.rows(); row += 8)
      for (int n = 0; n < 48; ++n) {
        const double angle = n * 0.1308996938995747, radius = surface.row(row).radius;
        const auto at = frame.pot->camera.project(
            {radius * std::cos(angle), surface.row(row).height, radius * std::sin(angle)});
        if (at && box.contains(at->first, at->second)) return true;
      }
    return false;
  }
  int faint_strokes() const {
    int n = 0;
    for (const auto& item : frame.items)
      if (const auto* line = std::get_if<view::Line>(&item))
        n += line->points.size() == 2 && view::same_hue(line->colors.front(), view::kPlaster) &&
             line->colors.front().a < 1;
    return n;
  }
  /// The next frame, so much later, s.
  void frame_after(double seconds) {
    visit->update(now += seconds);
    frame = visit->frame(width, height);
  }
  void stroke(float dx, float dy) {
    const auto [x, y] = middle();
    down(x, y);
    for (int n = 1; n <= 10; ++n) {
      move(x + dx * static_cast<float>(n) / 10, y + dy * static_cast<float>(n) / 10);
      show();
    }
    up(x + dx, y + dy);
    show();
  }
};

}  // namespace onggi::screens
