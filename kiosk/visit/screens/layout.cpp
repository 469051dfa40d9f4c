#include "kiosk/visit/screens/layout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kiosk/picture/view/type_scale.h"

namespace onggi::screens {

namespace {

constexpr double kReachLow = 380.0, kReachHigh = 1220.0;  // mm above the floor, from a wheelchair
constexpr float kLarger = 1.3f, kLeadOfLarger = 1.1f;
constexpr float kTitlesGive = 0.6f, kGapsGive = 0.4f;  // at most, of the size beyond body text
constexpr float kBodyStep = 0.94f;
constexpr float kLeastInReach = 1.0f / 3.0f;
constexpr float kPotInReach = 0.28f;  // of its height, in portrait
constexpr float kReadAbove = 0.6f;    // of the reach: higher text is too far from the buttons
constexpr float kUpright = 0.8f;      // of the width: a higher page has the pot above the words

double pixels_per_mm(const settings::Exhibit::Screen& screen, int width, int height) {
  return std::hypot(width, height) / std::max(screen.diagonal_mm, 100.0);
}

}  // namespace

view::Rect in_reach(const settings::Exhibit::Screen& screen, int width, int height) {
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  if (!screen.low_reach) return {0, 0, w, h};
  const double px_per_mm = pixels_per_mm(screen, width, height);
  const auto row = [&](double above_floor) {
    const double y = height - (above_floor - screen.lower_edge_mm) * px_per_mm;
    return static_cast<float>(std::clamp(std::round(y), 0.0, static_cast<double>(height)));
  };
  const float top = row(kReachHigh), foot = row(kReachLow);
  // A page completely out of reach gains nothing from a smaller area, and in less than a third of
  // the picture nobody can read or touch anything.
  if (foot - top < 1) return {0, 0, w, h};
  const float high = std::max(foot - top, kLeastInReach * h);
  const float from = std::max(0.0f, foot - high);
  return {0, from, w, high};
}

GiveWay give_way(int step, bool low) {
  // The first half of the titles' reduction costs less than a part of the pot's space.
  constexpr std::array<GiveWay, 5> kAll{{{0}, {0.5f}, {1}, {0.5f, true}, {1, true}}};
  // Higher text is seen from farther below, so use half of that space first.
  constexpr std::array<GiveWay, 7> kLow{
      {{0}, {0.5f}, {1}, {1, false, 0.5f}, {1, false, 1}, {0.5f, true, 1}, {1, true, 1}}};
  const auto of = [&](const auto& steps) {
    const int gives = static_cast<int>(steps.size());
    GiveWay way = steps[static_cast<std::size_t>(std::clamp(step, 0, gives - 1))];
    if (step >= gives) way.body = std::pow(kBodyStep, static_cast<float>(step - gives + 1));
    return way;
  };
  return low ? of(kLow) : of(kAll);
}

void read_above(Regions& r, float margin, float share) {
  if (share <= 0 || r.all.y <= 0) return;
  r.reach = r.all.y;
  const float up = share * std::clamp(r.page.y - margin, 0.0f, kReadAbove * r.all.h);
  r.page.y -= up;
  r.page.h += up;
  if (r.portrait) {
    const float most = std::max(0.0f, r.words.y - r.reach - kPotInReach * r.all.h);
    const float higher = std::min(up, share * most);
    r.words.y -= higher;
    r.words.h += higher;
    r.pot.h += up - higher;
    r.pot.y -= up;
    return;
  }
  r.words.y -= up;
  r.words.h += up;
}

TypeScale type_scale(const settings::Exhibit::Screen& screen, int width, int height,
                     const GiveWay& gives) {
  const view::Rect all = in_reach(screen, width, height);
  const auto short_side = static_cast<double>(std::min(all.w, all.h));
  const double px_per_mm = pixels_per_mm(screen, width, height);
  const float body =
      view::TypeScale::for_screen(width, height, screen.diagonal_mm, screen.viewing_distance_mm)
          .body();
  const view::TypeScale steps(std::min(body, static_cast<float>(std::min(width, height) / 28.0)) *
                              gives.body);

  TypeScale t;
  t.body = steps.body();
  const auto step = [&](int n) {
    return steps.px(n) - gives.titles * kTitlesGive * (steps.px(n) - steps.body());
  };
  t.lead = step(1);
  t.title = step(2);
  t.display = step(3);
  if (screen.larger_text) {
    // Small text becomes unreadable first. Titles are large, so they give up their space.
    t.body *= kLarger;
    t.lead = std::max(t.lead, t.body * kLeadOfLarger);
    t.title = std::max(t.title, t.lead);
    t.display = std::max(t.display, t.title);
  }
  // On a strip of a wall-sized screen, a tenth of the short side is less than 28 pixels.
  t.target = static_cast<float>(std::min(std::max(15.0 * px_per_mm, 28.0), short_side / 10.0));
  t.gap = t.body * 0.5f * (1 - gives.titles * kGapsGive);
  t.margin = static_cast<float>(std::round(short_side * 0.06));
  t.hairline = static_cast<float>(std::max(1.0, std::round(short_side / 720.0)));
  return t;
}

Regions regions(const view::Rect& all, float margin, bool mirrored, bool roomy) {
  const float w = all.w, h = all.h;
  Regions r;
  r.all = all;
  r.page = {margin, margin, w - 2 * margin, h - 2 * margin};
  r.portrait = h > w * kUpright;
  r.mirrored = mirrored;
  r.roomy = roomy;
  const auto lower = [&] {
    for (view::Rect* part : {&r.page, &r.words, &r.pot}) part->x += all.x, part->y += all.y;
    return r;
  };
  if (r.portrait) {
    r.pot = {margin * 2, margin * 1.5f, w - 4 * margin,
             std::round(h * (roomy ? 0.4f : 0.52f)) - margin * 1.5f};
    const float top = r.pot.y + r.pot.h + margin * 1.5f;
    r.words = {margin, top, w - 2 * margin, h - margin - top};
    return lower();
  }
  r.words = {margin, margin, std::round(w * (roomy ? 0.5f : 0.365f)), h - 2 * margin};
  // The axis is on the vertical third. The pot's half width is the space on both sides of it.
  const float axis = w * (roomy ? 0.77f : 2.0f / 3.0f);
  const float half = std::min(axis - (r.words.x + r.words.w + margin), w - axis);
  // Leave space above the rim, and for the wheel below the foot.
  r.pot = {axis - half, margin * 1.2f, 2 * half, h - margin * 3.4f};
  if (mirrored) {
    r.words.x = w - r.words.x - r.words.w;
    r.pot.x = w - r.pot.x - r.pot.w;
  }
  return lower();
}

}  // namespace onggi::screens
