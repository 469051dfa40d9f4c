#include "kiosk/exhibit/composition/staff_corner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kiosk/ground/files/log.h"
#include "kiosk/ground/secrets/digest.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/staff_notice.h"
#include "kiosk/picture/view/palette.h"
#include "kiosk/picture/view/square_code.h"

namespace onggi::exhibit {

namespace {

using view::InputEvent;
using Kind = InputEvent::Kind;

constexpr float kCorner = 0.1f;  // of the shorter side
constexpr float kStill = 0.04f;  // likewise: a finger that goes further is on its way

bool in_a_corner(const InputEvent& event, int width, int height) {
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  const float reach = kCorner * std::min(w, h);
  return std::min(event.x, w - event.x) < reach && std::min(event.y, h - event.y) < reach;
}

}  // namespace

std::vector<InputEvent> StaffCorner::pass(const InputEvent& event, int width, int height,
                                          double now) {
  if (!shown_.empty()) {
    if (event.kind == Kind::pointer_up) lifted_ = true;
    const bool again = event.kind == Kind::pointer_down || event.kind == Kind::key_down;
    if (lifted_ && again) shown_.clear();
    return {};
  }
  if (!held_) {
    if (event.kind != Kind::pointer_down || !in_a_corner(event, width, height)) return {event};
    address_ = souvenir::address_for_staff(keepsakes_);
    if (address_.empty()) return {event};
    held_ = event;
    since_ = now;
    return {};
  }
  const auto shorter = static_cast<float>(std::min(width, height));
  const bool still = event.kind == Kind::pointer_move && event.finger == held_->finger &&
                     std::hypot(event.x - held_->x, event.y - held_->y) < kStill * shorter;
  if (still) return {};
  return {*std::exchange(held_, std::nullopt), event};
}

void StaffCorner::show(double now) {
  held_.reset();
  const auto code = souvenir::Passes::new_token();
  if (!code) return files::log_problem(code.error());
  way_in_ = WayIn{secrets::digest_of(*code), wall_() + souvenir::kWayInLasts};
  shown_ = address_ + "/?code=" + *code;
  shown_since_ = now;
  lifted_ = false;
  files::log_line("The screen shows a way into the staff's page, because nobody has a name yet.");
}

void StaffCorner::draw(view::Frame& frame, const content::Language& language, double now) {
  if (held_ && now - since_ >= kHold) show(now);
  if (!shown_.empty() && now - shown_since_ > kShown) shown_.clear();
  if (shown_.empty()) return;
  const auto w = static_cast<float>(frame.width), h = static_cast<float>(frame.height);
  const float px = std::min(w, h) / 28, wide = std::min(0.86f * w, 34 * px), left = (w - wide) / 2;
  frame.items.emplace_back(view::Box{{0, 0, w, h}, 0, view::kPlaster, 0, {}});
  const auto line = [&](const std::string& words, float top, float size, float lines,
                        view::Face face = view::Face::sans) {
    view::Text text;
    text.text = words;
    text.style.face = face;
    text.style.px = size;
    text.style.align = view::Align::centre;
    text.style.language = language.code();
    text.style.right_to_left = language.right_to_left();
    text.color = view::kInk;
    text.box = {left, top, wide, lines * text.style.line_height * size};
    frame.items.emplace_back(std::move(text));
  };
  const view::SquareCode code(shown_);
  const float side = code.width(0.42f * std::min(w, h));
  const float top = std::max(0.5f * (h - side) - 8 * px, px);
  line(language.say("staff.title"), top, 1.4f * px, 1, view::Face::serif);
  line(language.say("staff.how"), top + 2.6f * px, px, 4);
  code.draw(frame.items, (w - side) / 2, top + 8.6f * px, 0.42f * std::min(w, h));
  line(shown_, top + 9.4f * px + side, 0.8f * px, 3);
}

}  // namespace onggi::exhibit
