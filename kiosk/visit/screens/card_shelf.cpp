#include "kiosk/visit/screens/card_shelf.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kiosk/visit/screens/star_drawing.h"

namespace onggi::screens {

using view::Face;
using view::Rect;

namespace {

constexpr float kPeek = 0.5f;       // of a card: the visible part of the next column
constexpr float kSlip = 5.0f / 15;  // of the least touch target: a finger that moves less is a tap
constexpr float kNarrowest = 9.5f;  // em: card width on a shelf longer than the screen
constexpr float kLeastPot = 0.28f;  // of the short side: lower pots get wider cards
constexpr float kLegible = 0.9f;    // of a card on the screen: from here on its words appear

}  // namespace

void CardWords::add(const std::string& words, Face face, float px, view::Color color) {
  if (words.empty()) return;
  auto style = page_.style(face, px, view::Align::centre);
  style.line_height = 1.25f;
  const auto size = page_.size(words, style, at_.w);
  widest_ = std::max({widest_, size.width, page_.longest_word(words, style)});
  if (widest_ > at_.w + 2) page_.overflowed();
  if (opacity_ > 0)
    page_.words({at_.x, y_, at_.w, size.height}, words, style, view::with_alpha(color, opacity_));
  y_ += size.height;
}

void CardWords::stars(int full) {
  const float size = page_.type().body * 0.95f, line = size * 1.5f;
  const float width = stars_width(size);
  if (opacity_ > 0)
    draw_stars(page_, {at_.x + (at_.w - width) / 2, y_, width, line}, full, size, opacity_);
  y_ += line;
}

void CardShelf::update(double dt) {
  if (finger_) watch_finger();
  scroll_.update(dt, desk_.still());
}

bool CardShelf::press(const std::string& control) {
  const bool onward = control == name_ + ".next";
  if (!onward && control != name_ + ".previous") return false;
  scroll_.step(onward ? scroll_.shown() : -scroll_.shown());
  return true;
}

void CardShelf::let_go() {
  finger_.reset();
  beside_.reset();
  scroll_.step(0);
}

void CardShelf::begin() {
  let_go();
  wanted_ = 0;
  scroll_ = {};
}

bool CardShelf::drag(const view::InputEvent& e) {
  using Kind = view::InputEvent::Kind;
  if (e.kind == Kind::pointer_down) beside_.reset();
  if (!scroll_.longer_than_the_screen() || pitch_ <= 0) return false;
  const float way = desk_.words().right_to_left() ? -1.0f : 1.0f;
  if (e.kind == Kind::pointer_down) {
    if (!shelf_.contains(e.x, e.y)) return false;
    const bool ran = scroll_.moving();
    finger_ = Finger{e.x, e.x, scroll_.at(), desk_.now, 0, ran};
    if (ran) scroll_.hold();
    return ran;  // a touch that stops the shelf does not choose a vessel
  }
  if (e.kind == Kind::pointer_up) tapped_ = finger_.has_value();
  if (!finger_) return false;
  if (e.kind == Kind::pointer_move) {
    if (!finger_->drags && std::abs(e.x - finger_->from) > slip_) {
      finger_->drags = true;
      scroll_.hold();
    }
    if (!finger_->drags) return false;
    scroll_.drag(static_cast<double>(way * (finger_->x - e.x) / pitch_));
    finger_->x = e.x;
    return true;
  }
  if (e.kind != Kind::pointer_up) return false;
  watch_finger();
  const Finger last = *std::exchange(finger_, std::nullopt);
  if (!last.drags) return false;
  scroll_.release(last.speed);
  return true;
}

std::string CardShelf::nearest(float x, float y) const {
  std::string found;
  float least = gap_;
  for (const auto& [card, control] : touchable_) {
    const float dx = std::max({card.x - x, x - card.x - card.w, 0.0f});
    const float dy = std::max({card.y - y, y - card.y - card.h, 0.0f});
    if (const float away = std::hypot(dx, dy); away < least) least = away, found = control;
  }
  return found;
}

std::string CardShelf::pointer(const view::InputEvent& e) {
  using Kind = view::InputEvent::Kind;
  if (e.kind == Kind::pointer_down) beside_.emplace(e.x, e.y);
  if (e.kind == Kind::scroll) {
    notches_ -= static_cast<double>(e.scroll);
    const int whole = static_cast<int>(notches_);
    notches_ -= whole;
    scroll_.step(whole);
  } else if (e.kind == Kind::pointer_up && tapped_ && peeking_.contains(e.x, e.y)) {
    scroll_.step(1);
  } else if (e.kind == Kind::pointer_up && beside_) {
    const auto [x, y] = *std::exchange(beside_, std::nullopt);
    if (std::hypot(e.x - x, e.y - y) <= slip_) return nearest(x, y);
  }
  return {};
}

int CardShelf::step(int from, Direction to) {
  const bool level = to == Direction::left || to == Direction::right;
  if (!level || !scroll_.longer_than_the_screen()) return -1;
  const bool onward = (to == Direction::right) != desk_.words().right_to_left();
  const int next = std::min(from + (onward ? rows_ : -rows_), cards_.count() - 1);
  if (next < 0 || next / rows_ == from / rows_) return -1;
  scroll_.show(next / rows_);
  return next;
}

int CardShelf::in_front() const {
  const int column = wanted_ / rows_;
  const bool seen = column >= scroll_.first() && column < scroll_.first() + scroll_.shown();
  return std::clamp(seen ? wanted_ : scroll_.first() * rows_, 0, std::max(0, cards_.count() - 1));
}

/// Speed of the finger that moves the shelf, over about the last tenth of a second: earlier motion
/// is not part of the throw. Measured by frames, because all events of one frame have the same
/// time.
void CardShelf::watch_finger() {
  const double dt = desk_.now - finger_->since;
  if (dt <= 0) return;
  const double speed = (scroll_.at() - finger_->at) / dt;
  finger_->speed += (speed - finger_->speed) * (1 - std::exp(-dt / 0.05));
  finger_->at = scroll_.at();
  finger_->since = desk_.now;
}

void CardShelf::lay_out(Page& page, Column& column) {
  touchable_.clear();
  if (cards_.count() == 0) return;
  column.into_reach();
  const TypeScale& t = page.type();
  // The type size sets how many cards stand side by side; the remaining height sets the rows.
  const float gap = t.body * 1.2f, margin = t.margin;
  gap_ = gap;
  slip_ = kSlip * t.target;
  const Rect whole = column.rest();
  const float narrowest = t.body * (page.where().portrait ? 10.5f : 11.0f);
  int columns = std::clamp(static_cast<int>((whole.w + gap) / (narrowest + gap)), 1,
                           std::max(1, cards_.count()));
  float width = (whole.w - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  // Never break a word on a card; use fewer columns instead.
  const auto too_wide = [&](float cards) {
    Page trial = page;
    words_of_all(trial, cards);
    return trial.overflow() && !page.overflow();
  };
  while (columns > 1 && too_wide(width)) {
    --columns;
    width = (whole.w - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  }
  float text_height = words_of_all(page, width);
  const auto rows_in = [&](float height) {
    return std::max(1, static_cast<int>((height + gap) / (t.body * 6.5f + text_height + gap)));
  };
  const Rect& all_of = page.where().all;
  const float least_pot = kLeastPot * std::min(all_of.w, all_of.h);
  rows_ = rows_in(whole.h);
  std::optional<Foot> foot;
  if (rows_ * columns < cards_.count()) {
    // The shelf continues beyond the screen's edge, where the next column is partly visible.
    const float least = kNarrowest * t.body;
    columns = std::max(1, static_cast<int>((whole.w + margin - kPeek * least) / (least + gap)));
    const auto peeking = [&](int abreast) {
      const auto n = static_cast<float>(abreast);
      return (whole.w + margin - gap * n) / (n + kPeek);
    };
    while (columns > 1 && too_wide(peeking(columns))) --columns;
    foot = foot_room(page, column);
    // Large words take the height of the pots: on wider cards they have fewer lines.
    for (;; --columns) {
      width = peeking(columns);
      text_height = words_of_all(page, width);
      rows_ = rows_in(column.rest().h);
      if (columns == 1 || rows_ > 1 || column.rest().h - text_height >= least_pot) break;
    }
  }
  const int all = (cards_.count() + rows_ - 1) / rows_;
  // For few vessels on a tall screen, use fewer rows with larger pictures.
  if (all <= columns) rows_ = (cards_.count() + columns - 1) / columns;
  scroll_.bound(std::max(all <= columns ? columns : all, 1), columns);
  if (const int wanted = std::exchange(shown_, wanted_); wanted != wanted_)
    scroll_.show(wanted_ / rows_);

  if (foot) draw_foot(page, *foot);
  const Rect area = column.rest();
  shelf_ = {page.where().all.x, area.y, page.where().all.w, area.h};
  pitch_ = width + gap;
  peeking_ = {0, 0, 0, 0};
  const float row_height =
      (area.h - gap * static_cast<float>(rows_ - 1)) / static_cast<float>(rows_);
  const float picture = row_height - text_height - t.gap * 0.5f;
  if (picture < t.body * 3) page.overflowed();
  for (int i = 0; i < cards_.count(); ++i) {
    const auto c = static_cast<float>(static_cast<double>(i / rows_) - scroll_.at());
    const auto r = static_cast<float>(i % rows_);
    float x = area.x + c * pitch_;
    if (desk_.words().right_to_left()) x = 2 * area.x + area.w - x - width;
    lay_out_card(page, i, {x, area.y + r * (row_height + gap), width, row_height}, picture,
                 text_height);
  }
}

float CardShelf::words_of_all(Page& page, float width) const {
  float height = 0;
  for (int i = 0; i < cards_.count(); ++i)
    height = std::max(height, cards_.words(page, i, {0, 0, width, 0}, 0));
  return height;
}

void CardShelf::lay_out_card(Page& page, int i, const Rect& card, float picture,
                             float text_height) {
  const Rect& all = page.where().all;
  const float left = std::max(card.x, all.x), right = std::min(card.x + card.w, all.x + all.w);
  const float share = (right - left) / card.w;
  if (share <= 0) return;
  const std::string control = cards_.control(i);
  if (share > 0.999f && !control.empty()) {
    page.control({control, card, cards_.spoken(i)});
    touchable_.emplace_back(card, control);
  } else if (share <= 0.999f && i / rows_ >= scroll_.first() + scroll_.shown()) {
    peeking_ = peeking_.w > 0 ? Rect{left, peeking_.y, right - left, card.y + card.h - peeking_.y}
                              : Rect{left, card.y, right - left, card.h};
  }
  const float inset = page.type().gap * 0.5f;
  if (const view::PictureId shown = cards_.picture(i); shown != 0)
    page.draw(view::Picture{
        {card.x + inset, card.y + inset, card.w - 2 * inset, picture - inset}, shown, 1});
  const float legible = std::clamp((share - kLegible) / (1 - kLegible), 0.0f, 1.0f);
  if (legible > 0)
    cards_.words(page, i, {card.x, card.y + picture + page.type().gap * 0.5f, card.w, text_height},
                 legible);
}

std::string CardShelf::count_of(int from, int to) const {
  return desk_.say("choose.page", {{"first", std::to_string(from)},
                                   {"last", std::to_string(to)},
                                   {"total", std::to_string(cards_.count())}});
}
std::array<Button, 2> CardShelf::ways(bool tight) const {
  std::array<Button, 2> both{Button{name_ + ".previous", desk_.say(name_ + ".previous")},
                             Button{name_ + ".next", desk_.say(name_ + ".next")}};
  for (Button& way : both) way.tight = tight;
  return both;
}

CardShelf::Foot CardShelf::foot_room(Page& page, Column& column) const {
  const TypeScale& t = page.type();
  const Rect whole = page.where().page;
  const std::string longest = count_of(cards_.count(), cards_.count());
  Foot foot;
  foot.height = t.target;
  float used = 0;
  for (const Control& c : page.controls())
    used = std::max(
        used, page.right_to_left() ? whole.x + whole.w - c.rect.x : c.rect.x + c.rect.w - whole.x);
  const auto words = page.size(longest, page.style(Face::sans, t.body), -1);
  for (const bool tight : {false, true}) {
    foot.tight = tight;
    foot.wanted = words.width + 4;
    for (const Button& b : ways(tight)) {
      const auto size = page.size(b, whole.w);
      foot.wanted += size.width + t.gap;
      foot.height = std::max(foot.height, size.height);
    }
    if (foot.wanted <= whole.w) break;
  }
  if (foot.wanted > whole.w) {
    foot.wanted -= words.width + 4 + t.gap;
    foot.count = words.height + t.gap * 0.5f;
    foot.height += foot.count;
  }
  foot.y = whole.y + whole.h - foot.height;
  if (used + foot.wanted + t.gap * 3 > whole.w) {
    foot.y = column.rest().y + column.rest().h - foot.height;
    column.foot_space(foot.height + t.gap * 1.5f);
    if (foot.wanted > whole.w + 1) page.overflowed();
  }
  foot.line = column.rest().y + column.rest().h;
  column.foot_space(std::max(3.0f, t.hairline * 3) + t.gap);
  return foot;
}

/// A scroll bar with its heavy part for the visible cards, the same in words, and buttons for
/// visitors who do not swipe.
void CardShelf::draw_foot(Page& page, const Foot& foot) const {
  const TypeScale& t = page.type();
  const Rect whole = page.where().page;
  const int first = scroll_.first() * rows_;
  const std::string count =
      count_of(first + 1, std::min(cards_.count(), first + scroll_.shown() * rows_));
  const auto style = page.style(Face::sans, t.body);
  const auto size = page.size(count, style, -1);
  const auto buttons = ways(foot.tight);
  const float widest = page.size(count_of(cards_.count(), cards_.count()), style, -1).width + 4;
  float x = whole.x + whole.w - foot.wanted;
  const bool own_row = foot.y + foot.height < whole.y + whole.h - 1;
  const auto turned = [&](float at, float width) {
    return page.right_to_left() ? 2 * whole.x + whole.w - at - width : at;
  };
  const bool over = foot.count > 0;
  page.words({turned(own_row || over ? whole.x : x, widest),
              over ? foot.y : foot.y + (foot.height - size.height) / 2, widest, size.height},
             count, style, view::kFaintInk);
  page.tell(foot.y, count);
  if (!over) x += widest + t.gap;
  for (const bool onward : {false, true}) {
    const Button& b = buttons[onward ? 1 : 0];
    const float width = page.size(b, whole.w).width;
    if (onward ? !scroll_.at_the_end() : scroll_.first() > 0)
      page.button(b, {turned(x, width), foot.y + foot.count, width, foot.height - foot.count});
    x += width + t.gap;
  }
  const float thick = std::max(3.0f, t.hairline * 3);
  const auto n = static_cast<float>(scroll_.columns());
  const float part = whole.w * static_cast<float>(scroll_.shown()) / n, most = whole.w - part;
  float at = std::clamp(whole.w * static_cast<float>(scroll_.at()) / n, 0.0f, most);
  if (desk_.words().right_to_left()) at = most - at;
  page.draw(view::Box{{whole.x, foot.line - thick * 0.6f, whole.w, t.hairline},
                      0,
                      view::with_alpha(view::kFaintInk, 0.5f),
                      0,
                      {}});
  page.draw(
      view::Box{{whole.x + at, foot.line - thick, part, thick}, thick / 2, view::kFaintInk, 0, {}});
}

}  // namespace onggi::screens
