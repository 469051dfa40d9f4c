#pragma once

#include <array>
#include <optional>
#include <string>

#include "kiosk/picture/view/input.h"
#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/focus.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/visit/screens/shelf_scroll.h"

namespace onggi::screens {

/// A card's words below each other, in the middle of `at` from its top. Nothing is drawn where
/// `opacity` is 0; words that `at` is too narrow for are told to `page`. One use.
class CardWords {
 public:
  CardWords(Page& page, const view::Rect& at, float opacity)
      : page_(page), at_(at), opacity_(opacity), y_(at.y) {}
  /// On as many lines as it takes; "" takes none.
  void add(const std::string& words, view::Face face, float px, view::Color color);
  /// Of what was added, and a little room.
  float height() const { return y_ - at_.y + page_.type().gap * 0.5f; }

 private:
  Page& page_;
  view::Rect at_;
  float opacity_, y_, widest_ = 0;
};

/// Cards with a picture and words each, in rows and columns: a page of them, or a shelf that goes
/// along with a finger, with a line and words that say how much more there is, and two buttons for
/// who does not swipe.
class CardShelf {
 public:
  /// What stands on it.
  class Cards {
   public:
    virtual ~Cards() = default;
    virtual int count() const = 0;
    virtual view::PictureId picture(int i) const = 0;
    /// Its words, from the top of `at`; gives their height. Draws where `opacity` is more than 0.
    virtual float words(Page& page, int i, const view::Rect& at, float opacity) const = 0;
    /// Its words in a line, for who is told what it is.
    virtual std::string spoken(int i) const = 0;
    /// What a touch on it presses; empty: nothing.
    virtual std::string control(int i) const = 0;
  };

  /// `name`.next and `name`.previous are its buttons, and so are their words called. Card `wanted`
  /// is to be seen at first. Both outlive it.
  CardShelf(const Desk& desk, const Cards& cards, std::string name, int wanted = 0)
      : desk_(desk), cards_(cards), name_(std::move(name)), wanted_(wanted) {}

  void update(double dt);
  /// True where it was one of its two buttons.
  bool press(const std::string& control);
  void let_go();
  /// A finger that goes along the shelf takes it with it; one that does not, taps. As Screen::drag.
  bool drag(const view::InputEvent& e, const Page& page);
  /// A wheel turns it by a column a notch, and so does a touch on the card that peeks in.
  void pointer(const view::InputEvent& e);
  /// The card that an arrow leads to beyond the last column that is seen whole, which comes; -1:
  /// the arrow stays on the screen.
  int step(int from, Direction to);
  /// The cards into what is left of `column`; at the foot of it stands already what else is there.
  void lay_out(Page& page, Column& column);

  /// The first card is in front, at once.
  void begin();
  /// Card `i` is to be seen from the next picture on.
  void want(int i) { wanted_ = i; }
  /// The card where the keyboard begins: the one that is wanted, if it is seen.
  int in_front() const;

 private:
  struct Finger {
    float from, x;
    double at, since;  ///< Where the shelf was when it was last looked at, and when.
    double speed;      ///< Columns/s.
    bool drags;
  };
  /// Where that stands which says how much more there is: beside Back and Help where there is room,
  /// else above.
  struct Foot {
    float wanted = 0, y = 0, height = 0, line = 0;
    bool tight = false;  ///< Less air in the buttons;
    float count = 0;     ///< where that does not do, the words stand over them, so high.
  };

  void watch_finger();
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
  int wanted_ = 0, shown_ = -1;  ///< A card that is to be seen; the one that last was.
  float pitch_ = 0;              ///< Pixels from a column to the next.
  view::Rect shelf_, peeking_;  ///< Where a finger takes it along; what is seen of the next column.
  std::optional<Finger> finger_;
  bool tapped_ = false;  ///< What lifted last went down here too, and not on the screen before.
  double notches_ = 0;
};

}  // namespace onggi::screens
