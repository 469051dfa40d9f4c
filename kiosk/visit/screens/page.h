#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/palette.h"
#include "kiosk/visit/screens/layout.h"
#include "kiosk/visit/screens/measuring.h"

namespace onggi::screens {

/// Something that can be pressed, with its spoken description.
struct Control {
  std::string id;
  view::Rect rect;
  std::string words = {};       ///< Its name.
  std::optional<bool> on = {};  ///< For a switch or a choice: its state.
  std::string note = {};        ///< Further state, for speech.
  bool by_keys = false;         ///< Only for keys and the switch; a finger does it directly.
};

/// The control that has the keyboard, and the one that a finger holds down; both may be empty.
struct Attention {
  std::string focused, pressed;
};

/// The look of a control. Cobalt always means that it can be touched.
enum class Look {
  quiet,    ///< Words with a hairline below; tinted where Button::on.
  outline,  ///< Words in a hairline frame.
  chosen,   ///< An outline with a tint and a tick at its corner: a switch or a choice that is on.
  called,   ///< An outline with a tint: it would help now.
  solid,    ///< The main step onward: at most one on a screen.
  plain,    ///< Words among buttons; cannot be pressed.
  resting,  ///< A button that has nothing to do yet, at its place; cannot be pressed.
};

struct Button {
  std::string id, words;
  Look look = Look::outline;
  std::string room = {};   ///< Space is reserved for this longest text, if the words change.
  std::string other = {};  ///< A switch: `words` | `other`, one of them on.
  bool other_on = false;
  std::optional<view::Color> swatch = {};  ///< A test tile of this glaze before the words.
  /// A drawing in place of the words (pen_strokes). In a row of foot_buttons() it stands in the
  /// words' outer corner of the page, the same place on every screen.
  std::string_view drawing = {};
  /// Lines in place of the words, in a square from (0, 0) to (1, 1).
  std::vector<std::vector<std::pair<float, float>>> sketch = {};
  bool tight = false;           ///< Less space beside the words.
  std::string language = {};    ///< Language code of the words, if it differs from the page's.
  std::optional<bool> on = {};  ///< State for speech, if the button stays on.
  std::string note = {};        ///< Control::note.
  std::string spoken = {};      ///< Its name for speech, if its words are drawn elsewhere.
};

struct Sheet {
  int width = 0, height = 0;  ///< Pixels.
  TypeScale type;
  Regions where;
  std::string language;  ///< Language code.
  Attention attention;
  bool right_to_left = false;  ///< A right-to-left language: rows begin at the right.
};

/// Words and controls of one screen during layout. Every text is measured before it is placed.
/// `overflow` means that something did not fit; the page is then laid out again with smaller sizes.
class Page {
 public:
  Page(Measuring& measuring, Sheet sheet) : measuring_(measuring), sheet_(std::move(sheet)) {}

  const TypeScale& type() const { return sheet_.type; }
  const Regions& where() const { return sheet_.where; }
  /// Divides the page differently from here on. Earlier items stay.
  void divide(const Regions& where) { sheet_.where = where; }
  bool right_to_left() const { return sheet_.right_to_left; }
  int width() const { return sheet_.width; }
  int height() const { return sheet_.height; }

  view::TextStyle style(view::Face face, float px, view::Align align = view::Align::start) const;
  view::TextMeasure::Size size(const std::string& words, const view::TextStyle& style,
                               float at_most) const;

  /// Width of the longest word of `words`. 0 in a language without spaces, where only the
  /// typesetter knows.
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
  bool focused(const std::string& id) const { return sheet_.attention.focused == id; }
  /// Adds words to the reading, besides those of controls. `y`: their place.
  void tell(float y, const std::string& words) { told_.emplace_back(y, words); }
  /// The added words, from the top of the page down.
  std::vector<std::string> told() const;
  void overflowed() { overflow_ = true; }
  /// Call if the screen learned something during layout and needs another one.
  void restart() { restart_ = true; }

  bool restarted() const { return restart_; }
  bool overflow() const { return overflow_; }
  /// Touch targets stay below Regions::reach.
  bool in_reach() const { return !out_of_reach_; }
  const std::vector<Control>& controls() const { return controls_; }
  std::vector<view::Item>& items() { return items_; }

 private:
  void focus_ring(const view::Rect& rect);
  void touched(const Control& control);
  void test_tile(const view::Rect& rect, view::Color glaze);
  void drawn(const Button& button, const view::Rect& rect);
  void sketched(const Button& button, const view::Rect& rect);
  /// The tick at the far upper corner of a choice that is on.
  void tick(const view::Rect& rect);
  void switch_halves(const Button& button, const view::Rect& rect);

  Measuring& measuring_;
  Sheet sheet_;
  std::vector<view::Item> items_;
  std::vector<Control> controls_;
  std::vector<std::pair<float, std::string>> told_;
  bool overflow_ = false, restart_ = false, out_of_reach_ = false;
};

/// Fills a rectangle from its top and from its foot until they meet.
class Column {
 public:
  Column(Page& page, const view::Rect& box)
      : page_(page), box_(box), top_(box.y), foot_(box.y + box.h) {}

  Page& page() const { return page_; }
  void space(float px) { top_ += px; }
  void foot_space(float px) { foot_ -= px; }
  /// The next items from the top are touch targets.
  void into_reach() { top_ = std::max(top_, page_.where().reach); }
  /// A paragraph, at most 55 characters wide.
  void text(const std::string& words, float px, view::Face face = view::Face::sans,
            view::Color color = view::kInk, view::Align align = view::Align::start);
  /// Of such a paragraph, in the face for running text.
  float height_of(const std::string& words, float px) const;
  /// Buttons side by side, in several rows if needed. `caption`, in second rank, comes before the
  /// first in a column of `caption_width`.
  void buttons(const std::vector<Button>& row, const std::string& caption = {},
               float caption_width = 0);
  void foot_buttons(std::vector<Button> row);
  /// Buttons of equal width and at least `height`, side by side if their words fit: all in a row,
  /// half of them, or one. A button without an id keeps its place and is not drawn, unless it
  /// rests. `mirrored`: from the far side.
  void foot_grid(const std::vector<Button>& cells, float height, bool mirrored);
  /// How many of them fit side by side in foot_grid().
  std::size_t abreast(const std::vector<Button>& cells) const;
  /// Five stars with the first `full` of them filled, and the same in words after them, or below
  /// them if there is no space.
  void stars(int full, const std::string& words);
  view::Rect rest() const { return {box_.x, top_, box_.w, foot_ - top_}; }
  void check() const;

 private:
  /// `x` for an item of `width` on a right-to-left page.
  float turned(float x, float width) const {
    return page_.right_to_left() ? 2 * box_.x + box_.w - x - width : x;
  }
  struct Placed {
    Button button;
    view::Rect rect;
  };
  float line_width(float px) const;
  /// Rows for `row` from y = 0, between x = indent and x = end; returns their height.
  float flow(const std::vector<Button>& row, float indent, float end,
             std::vector<Placed>& placed) const;
  void place(std::vector<Placed>& placed, float y, const std::string& caption, float caption_width);

  Page& page_;
  view::Rect box_;
  float top_, foot_;
};

}  // namespace onggi::screens
