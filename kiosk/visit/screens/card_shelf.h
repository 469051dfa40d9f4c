#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/picture/view/input.h"
#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/focus.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/visit/screens/shelf_scroll.h"

namespace onggi::screens {

/// A card's words below each other, centred in `at`. Draws nothing if `opacity` is 0. Reports words
/// that do not fit `at` to `page`. Use each object once.
class CardWords {
 public:
  CardWords(Page& page, const view::Rect& at, float opacity)
      : page_(page), at_(at), opacity_(opacity), y_(at.y) {}
  /// Uses as many lines as needed; "" needs none.
  void add(const std::string& words, view::Face face, float px, view::Color color);
  /// A line of five stars, the first `full` of them filled.
  void stars(int full);
  /// Height of the added lines, with some space below.
  float height() const { return y_ - at_.y + page_.type().gap * 0.5f; }

 private:
  Page& page_;
  view::Rect at_;
  float opacity_, y_, widest_ = 0;
};

/// Cards with a picture and words each, in rows and columns: one page, or a shelf that a finger
/// moves. A shelf has a scroll bar, words that tell how much more there is, and two buttons for
/// visitors who do not swipe.
class CardShelf {
 public:
  class Cards {
   public:
    virtual ~Cards() = default;
    virtual int count() const = 0;
    virtual view::PictureId picture(int i) const = 0;
    /// Draws its words from the top of `at` if `opacity` is above 0; returns their height.
    virtual float words(Page& page, int i, const view::Rect& at, float opacity) const = 0;
    /// Its words in one line, for speech.
    virtual std::string spoken(int i) const = 0;
    /// The control that a touch on it presses; empty: none.
    virtual std::string control(int i) const = 0;
  };

  /// Its buttons are `name`.next and `name`.previous, with language keys of the same names. Card
  /// `wanted` is visible at first. `desk` and `cards` must outlive it.
  CardShelf(const Desk& desk, const Cards& cards, std::string name, int wanted = 0)
      : desk_(desk), cards_(cards), name_(std::move(name)), wanted_(wanted) {}

  void update(double dt);
  /// True if `control` was one of its two buttons.
  bool press(const std::string& control);
  void let_go();
  /// A finger that moves along the shelf moves it; a finger that stays taps. Like Screen::drag.
  bool drag(const view::InputEvent& e);
  /// A mouse wheel's notch, or a touch on the partly visible card, moves it by one column. Returns
  /// the control of the nearer card if a finger tapped between two; else "".
  std::string pointer(const view::InputEvent& e);
  /// The card beyond the last whole column that an arrow reaches; the shelf scrolls to it. -1: the
  /// arrow stays on the screen.
  int step(int from, Direction to);
  /// Lays out the cards in the free part of `column`. The foot must already hold the other
  /// controls.
  void lay_out(Page& page, Column& column);

  /// Moves the first card to the front at once.
  void begin();
  /// Makes card `i` visible from the next frame on.
  void want(int i) { wanted_ = i; }
  /// The card where the keyboard starts: the wanted one, if visible.
  int in_front() const;

 private:
  struct Finger {
    float from, x;
    double at, since;  ///< Position of the shelf in the last frame, and its time.
    double speed;      ///< Columns/s.
    bool drags;
  };
  /// The words about how much more there is: beside Back and Help if there is space, else above
  /// them.
  struct Foot {
    float wanted = 0, y = 0, height = 0, line = 0;
    bool tight = false;  ///< The buttons have less space;
    float count = 0;     ///< if that is not enough, the words are above them, this high.
  };

  void watch_finger();
  std::string nearest(float x, float y) const;
  float words_of_all(Page& page, float width) const;
  void lay_out_card(Page& page, int i, const view::Rect& card, float picture, float text_height);
  std::string count_of(int from, int to) const;
  std::array<Button, 2> ways(bool tight) const;
  Foot foot_room(Page& page, Column& column) const;
  void draw_foot(Page& page, const Foot& foot) const;

  const Desk& desk_;
  const Cards& cards_;
  std::string name_;
  ShelfScroll scroll_;
  int rows_ = 1;
  int wanted_ = 0, shown_ = -1;  ///< The card that must be visible; the last one that was.
  float pitch_ = 0;              ///< Pixels between two columns.
  view::Rect shelf_, peeking_;   ///< Area where a finger moves it; visible part of the next column.
  /// The cards that can be touched; the space between two; and how far a tap may slip.
  std::vector<std::pair<view::Rect, std::string>> touchable_;
  float gap_ = 0, slip_ = 0;
  std::optional<std::pair<float, float>> beside_;  ///< Where a finger went down between cards.
  std::optional<Finger> finger_;
  bool tapped_ = false;  ///< The lifted finger also went down here, not on an earlier screen.
  double notches_ = 0;
};

}  // namespace onggi::screens
