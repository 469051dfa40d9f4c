#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/palette.h"
#include "kiosk/visit/screens/layout.h"
#include "kiosk/visit/screens/measuring.h"

namespace onggi::screens {

/// Something that can be pressed, and what it is to somebody who is told it.
struct Control {
  std::string id;
  view::Rect rect;
  std::string words = {};       ///< Its name.
  std::optional<bool> on = {};  ///< Of a switch or a choice: whether it is on.
  std::string note = {};        ///< What else is so of it just now.
  bool by_keys = false;         ///< For keys and the switch: a finger does there what it does.
};

/// Which control the keyboard is on and which one a finger holds down; both may be empty.
struct Attention {
  std::string focused, pressed;
};

/// How a control looks. Cobalt and nothing else says that it can be touched.
enum class Look {
  quiet,    ///< Words with a hairline under them.
  outline,  ///< Words in a hairline frame.
  solid,    ///< The one step onward of a screen, and whatever is switched on.
  plain,    ///< Words among buttons that cannot be pressed.
};

struct Button {
  std::string id, words;
  Look look = Look::outline;
  std::string room = {};   ///< The longest words that will stand here, if these change.
  std::string other = {};  ///< A switch: `words` | `other`, one of them on.
  bool other_on = false;
  std::optional<view::Color> swatch = {};  ///< A disc of this colour before the words.
  bool tight = false;                      ///< Less air beside the words.
  std::string language = {};    ///< Code of the words, where they are of another than the page.
  std::optional<bool> on = {};  ///< Of one that stays on: whether it is, in words.
  std::string note = {};        ///< Control::note.
};

/// What a page is set on.
struct Sheet {
  int width = 0, height = 0;  ///< Pixels.
  TypeScale type;
  Regions where;
  std::string language;  ///< Code.
  Attention attention;
  bool right_to_left = false;  ///< The language is read so: rows begin at the right.
};

/// The words and controls of one screen while it is laid out. Every text is measured before it is
/// placed; `overflow` says that something did not fit, and the page is then set again smaller.
class Page {
 public:
  Page(Measuring& measuring, Sheet sheet) : measuring_(measuring), sheet_(std::move(sheet)) {}

  const TypeScale& type() const { return sheet_.type; }
  const Regions& where() const { return sheet_.where; }
  /// The screen divides the page otherwise; what is laid out already stays where it is.
  void divide(const Regions& where) { sheet_.where = where; }
  bool right_to_left() const { return sheet_.right_to_left; }
  int width() const { return sheet_.width; }
  int height() const { return sheet_.height; }

  view::TextStyle style(view::Face face, float px, view::Align align = view::Align::start) const;
  view::TextMeasure::Size size(const std::string& words, const view::TextStyle& style,
                               float at_most) const;

  /// Width of the longest word of `words`; 0 in a language that is written without spaces, where
  /// the typesetter alone knows.
  float longest_word(const std::string& words, const view::TextStyle& style) const;

  /// Words at a place that was measured for them.
  void words(const view::Rect& box, const std::string& words, const view::TextStyle& style,
             view::Color color);
  void draw(view::Item item) { items_.push_back(std::move(item)); }
  /// Size that `button` needs when at most `width` wide.
  view::TextMeasure::Size size(const Button& button, float at_most) const;
  void button(const Button& button, const view::Rect& rect);
  /// A control whose words are drawn elsewhere (a card); draws its focus and touch.
  void control(const Control& control);
  /// The keyboard is on it.
  bool focused(const std::string& id) const { return sheet_.attention.focused == id; }
  /// Words that are read, beside those of controls; `y`: where they stand.
  void tell(float y, const std::string& words) { told_.emplace_back(y, words); }
  /// They, from the top of the page down.
  std::vector<std::string> told() const;
  void overflowed() { overflow_ = true; }
  /// The screen learned something while laying out and wants to be laid out once more.
  void restart() { restart_ = true; }

  bool restarted() const { return restart_; }
  bool overflow() const { return overflow_; }
  /// Nothing stands above Regions::reach that is touched.
  bool in_reach() const { return !out_of_reach_; }
  const std::vector<Control>& controls() const { return controls_; }
  std::vector<view::Item>& items() { return items_; }

 private:
  void focus_ring(const view::Rect& rect);
  void touched(const Control& control);
  void switch_halves(const Button& button, const view::Rect& rect);

  Measuring& measuring_;
  Sheet sheet_;
  std::vector<view::Item> items_;
  std::vector<Control> controls_;
  std::vector<std::pair<float, std::string>> told_;
  bool overflow_ = false, restart_ = false, out_of_reach_ = false;
};

/// Fills a rectangle from its top and from its foot until both meet.
class Column {
 public:
  Column(Page& page, const view::Rect& box)
      : page_(page), box_(box), top_(box.y), foot_(box.y + box.h) {}

  Page& page() const { return page_; }
  void space(float px) { top_ += px; }
  void foot_space(float px) { foot_ -= px; }
  /// What comes next from the top is touched.
  void into_reach() { top_ = std::max(top_, page_.where().reach); }
  /// A paragraph, at most 55 characters wide.
  void text(const std::string& words, float px, view::Face face = view::Face::sans,
            view::Color color = view::kInk, view::Align align = view::Align::start);
  void foot_text(const std::string& words, float px, view::Face face = view::Face::sans,
                 view::Color color = view::kInk);
  /// Buttons beside one another, wrapping into further rows. `caption`, in second rank, stands
  /// before the first in a column of `caption_width`.
  void buttons(const std::vector<Button>& row, const std::string& caption = {},
               float caption_width = 0);
  void foot_buttons(const std::vector<Button>& row, const std::string& caption = {},
                    float caption_width = 0);
  /// Buttons of one width and at least `height`, as many beside one another as hold their words:
  /// all, half of them, or one. One without an id keeps its place and is not drawn. `mirrored`:
  /// from the far side.
  void foot_grid(const std::vector<Button>& cells, float height, bool mirrored);
  /// How many of them that is.
  std::size_t abreast(const std::vector<Button>& cells) const;
  /// `count` circles, the first `full` of them filled, and the same in words after them or, where
  /// that has no room, below.
  void circles(int full, int count, const std::string& words);
  /// What is left between top and foot.
  view::Rect rest() const { return {box_.x, top_, box_.w, foot_ - top_}; }
  void check() const;

 private:
  /// `x` of what is `width` wide, where the page is read from the right.
  float turned(float x, float width) const {
    return page_.right_to_left() ? 2 * box_.x + box_.w - x - width : x;
  }
  struct Placed {
    Button button;
    view::Rect rect;
  };
  /// Rows for `row` from y = 0 and x = indent; gives their height.
  float flow(const std::vector<Button>& row, float indent, std::vector<Placed>& placed) const;
  void place(std::vector<Placed>& placed, float y, const std::string& caption, float caption_width);

  Page& page_;
  view::Rect box_;
  float top_, foot_;
};

}  // namespace onggi::screens
