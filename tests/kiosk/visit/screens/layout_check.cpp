#include "tests/kiosk/visit/screens/layout_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kiosk/picture/view/high_contrast.h"
#include "kiosk/picture/view/palette.h"
#include "kiosk/visit/screens/comfort.h"
#include "kiosk/visit/screens/layout.h"

namespace onggi::screens {

using view::Rect;

namespace {

constexpr float kTouching = 1.5f;  // Pixels that may meet: hairlines, rounding.

bool overlap(const Rect& a, const Rect& b) {
  return a.x + a.w - kTouching > b.x && b.x + b.w - kTouching > a.x &&
         a.y + a.h - kTouching > b.y && b.y + b.h - kTouching > a.y;
}

bool inside(const Rect& a, const Rect& b) {
  return a.x >= b.x - kTouching && a.y >= b.y - kTouching && a.x + a.w <= b.x + b.w + kTouching &&
         a.y + a.h <= b.y + b.h + kTouching;
}

std::string print(const Rect& r) {
  return std::to_string(r.x) + "," + std::to_string(r.y) + " " + std::to_string(r.w) + "x" +
         std::to_string(r.h);
}

struct Words {
  Rect rect;
  std::string text;
};

std::string comforts(const settings::Exhibit::Screen& screen) {
  std::string all;
  for (const Comfort::Choice& choice : Comfort::kChoices)
    if (screen.*choice.of) all += std::string(" ") + choice.name;
  return all;
}

view::Color over(view::Color top, view::Color ground) {
  const auto mix = [&](float a, float b) { return a * top.a + b * (1 - top.a); };
  return {mix(top.r, ground.r), mix(top.g, ground.g), mix(top.b, ground.b), 1};
}

/// What the `count` first items leave at a place, on plaster where it is darkest: in the corner
/// that is farthest from the window (kiosk/picture/render/shaders/plaster.glsl).
view::Color ground_at(const std::vector<view::Item>& items, std::size_t count, float x, float y) {
  view::Color ground{0.8811f, 0.8597f, 0.8294f, 1};
  for (std::size_t i = 0; i < count; ++i)
    if (const auto* box = std::get_if<view::Box>(&items[i]); box && box->rect.contains(x, y))
      ground = over(box->fill, ground);
  return ground;
}

/// Words are told from what they stand on, but while they fade in.
void check_contrast(const Visitor& v, const std::string& where) {
  const double least = v.visit->shown_on().high_contrast ? 7.0 : 4.5;
  const auto& items = v.frame.items;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto* text = std::get_if<view::Text>(&items[i]);
    if (text == nullptr || text->color.a < 1) continue;
    const Rect& box = text->box;
    const auto ground = ground_at(items, i, box.x + box.w / 2, box.y + box.h / 2);
    EXPECT_GE(view::contrast(text->color, ground), least) << where << ": faint: " << text->text;
  }
}

/// No control stands on the wheel head, and all of that is on the screen.
void check_wheel(const Visitor& v, const std::string& where) {
  const auto& pot = v.frame.pot;
  if (!pot || !pot->wheel || pot->opacity < 0.5) return;
  constexpr double kThick = 0.024;
  for (int i = 0; i < 48; ++i)
    for (const double y : {0.0, -kThick}) {
      const double a = i * 0.1308996938995747, r = pot->wheel_radius;
      const auto at = pot->camera.project({r * std::cos(a), y, r * std::sin(a)});
      ASSERT_TRUE(at) << where;
      const auto [px, py] = *at;
      EXPECT_GE(px, -kTouching) << where << ": the wheel head is cut";
      EXPECT_LE(px, static_cast<float>(v.width) + kTouching) << where << ": the wheel head is cut";
      for (const Control& c : v.visit->reading().controls) {
        EXPECT_FALSE(!c.by_keys && c.rect.contains(px, py))
            << where << ": " << c.id << " lies on the wheel head";
      }
    }
}

/// Where a pot's shadow falls on the table, to the end of its soft edge, pixels
/// (kiosk/picture/render/shaders/shadow.glsl).
void add_shadow(std::vector<std::pair<float, float>>& all, const view::PotView& pot,
                const view::Camera& camera, const Profile& shape, double size) {
  const Vec3 window = view::window_at(pot.window);
  const double table = pot.wheel ? -0.024 : 0.0;
  const std::size_t step = std::max<std::size_t>(1, shape.points.size() / 16);
  for (std::size_t i = 0; i < shape.points.size(); i += step) {
    const double high = size * shape.points[i].height - table, along = high / window.y;
    const double soft = 0.45 * (0.0025 + 0.24 * high / 0.54);  // 0.54: of the unit vector
    for (int k = 0; k < 24; ++k) {
      const double a = k * 0.2617993877991494, r = size * shape.points[i].outer + soft;
      const auto at = camera.project(
          {r * std::cos(a) - window.x * along, table, r * std::sin(a) - window.z * along});
      if (at) all.push_back(*at);
    }
  }
}

/// Nothing that is touched stands in the shadow of what stands on the page.
void check_shadow(const Visitor& v, const std::string& where) {
  const auto& pot = v.frame.pot;
  if (!pot || pot->opacity < 0.5) return;
  std::vector<std::pair<float, float>> shadow;
  add_shadow(shadow, *pot, pot->camera, v.clay.profile(), pot->size);
  if (pot->beside) add_shadow(shadow, *pot, pot->beside->camera, v.shelf.front().target, 1);
  for (const Control& c : v.visit->reading().controls)
    for (const auto& [x, y] : shadow)
      if (!c.by_keys && c.rect.contains(x, y)) {
        ADD_FAILURE() << where << ": " << c.id << " stands in the shadow";
        break;
      }
}

/// One step onward at most is solid: what is on or chosen looks different.
void check_solid(const Visitor& v, float target, const std::string& where) {
  int solid = 0;
  for (const view::Item& item : v.frame.items)
    if (const auto* box = std::get_if<view::Box>(&item))
      solid += (view::same_hue(box->fill, view::kCobalt) ||
                view::same_hue(box->fill, view::in_high_contrast(view::kCobalt))) &&
               box->fill.a > 0.9f && std::min(box->rect.w, box->rect.h) >= target;
  EXPECT_LE(solid, 1) << where << ": two buttons look like the step onward";
}

/// Millimetres above the floor, of a row of pixels.
double above_floor(const Visitor& v, float y) {
  const settings::Exhibit::Screen screen = v.visit->shown_on();
  const double mm = screen.diagonal_mm / std::hypot(v.width, v.height);
  return screen.lower_edge_mm + mm * (v.height - static_cast<double>(y));
}

}  // namespace

void check_layout(const Visitor& v, const view::TextMeasure& measure, const std::string& name) {
  const std::string where = name + " " + std::to_string(v.width) + "x" + std::to_string(v.height) +
                            " " + v.visit->language() + comforts(v.visit->shown_on());
  const Rect screen{0, 0, static_cast<float>(v.width), static_cast<float>(v.height)};
  settings::Exhibit::Screen usual = v.visit->shown_on();
  usual.larger_text = false;
  const TypeScale type = type_scale(usual, v.width, v.height);
  // EN 301 549 5.1.4: capitals of 0.7 degrees, on every screen. Where a visitor reaches only a part
  // of an upright one, that is too narrow for a pot beside controls of such words.
  const bool narrow = usual.low_reach && v.height > v.width;
  const float least = (narrow ? 0.82f : 0.999f) * type.body;

  check_contrast(v, where);
  check_solid(v, type.target, where);
  check_wheel(v, where);
  check_shadow(v, where);
  if (v.visit->shown_on().low_reach)
    for (const Control& c : v.visit->reading().controls) {
      // The pots that a finger turns may stand higher: it does so by their lower part.
      const double top = above_floor(v, c.rect.y), foot = above_floor(v, c.rect.y + c.rect.h);
      EXPECT_LE(c.by_keys ? foot + 35 : top, 1220.5) << where << ": " << c.id;
      EXPECT_GE(foot, 379.5) << where << ": " << c.id;
    }

  std::vector<Words> words;
  std::vector<Rect> pictures;
  for (const view::Item& item : v.frame.items) {
    if (const auto* picture = std::get_if<view::Picture>(&item)) pictures.push_back(picture->box);
    const auto* text = std::get_if<view::Text>(&item);
    if (text == nullptr) continue;
    const auto size = measure.measure(text->text, text->style, text->box.w);
    EXPECT_LE(size.width, text->box.w + kTouching) << where << ": cut: " << text->text;
    EXPECT_LE(size.height, text->box.h + kTouching) << where << ": cut: " << text->text;
    if (text->color.a > 0) {
      EXPECT_GE(text->style.px, least) << where << ": too small: " << text->text;
    }
    EXPECT_EQ(text->text.find('['), std::string::npos) << where << ": " << text->text;
    EXPECT_EQ(text->text.find('{'), std::string::npos) << where << ": " << text->text;
    Rect ink{text->box.x, text->box.y, size.width, size.height};
    const bool from_right = v.visit->language() == "xr";
    if (from_right && text->style.align == view::Align::start) ink.x += text->box.w - size.width;
    if (text->style.align == view::Align::centre) ink.x += (text->box.w - size.width) / 2;
    EXPECT_TRUE(inside(ink, screen))
        << where << ": off the screen: " << text->text << " " << print(ink);
    words.push_back({ink, text->text});
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    for (std::size_t k = i + 1; k < words.size(); ++k)
      EXPECT_FALSE(overlap(words[i].rect, words[k].rect))
          << where << ": \"" << words[i].text << "\" " << print(words[i].rect) << " overlaps \""
          << words[k].text << "\" " << print(words[k].rect);
    for (const Rect& picture : pictures)
      EXPECT_FALSE(overlap(words[i].rect, picture))
          << where << ": a picture lies over \"" << words[i].text << "\"";
  }
  const auto controls = v.visit->controls();
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const Rect& a = controls[i].second;
    EXPECT_GE(std::min(a.w, a.h), type.target - 0.5f) << where << ": " << controls[i].first;
    EXPECT_TRUE(inside(a, screen)) << where << ": " << controls[i].first << " " << print(a);
    for (std::size_t k = i + 1; k < controls.size(); ++k)
      EXPECT_FALSE(overlap(a, controls[k].second))
          << where << ": " << controls[i].first << " " << print(a) << " overlaps "
          << controls[k].first << " " << print(controls[k].second);
    for (const Words& w : words)
      EXPECT_TRUE(!overlap(a, w.rect) || inside(w.rect, a))
          << where << ": " << controls[i].first << " cuts \"" << w.text << "\"";
  }
}

}  // namespace onggi::screens
