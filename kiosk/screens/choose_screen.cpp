#include "kiosk/screens/choose_screen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kiosk/content/address.h"
#include "kiosk/score/likeness.h"
#include "kiosk/screens/label.h"
#include "kiosk/screens/overlays.h"
#include "kiosk/view/square_code.h"

namespace onggi::screens {

using view::Face;
using view::Rect;

namespace {

/// What the vessel measures on the wheel, of its true size.
int percent_of_size(const ShelfCard& card) {
  return static_cast<int>(std::lround(100.0 * card.scale));
}

/// The shelf, and over it the label of the vessel that was touched.
class Choose final : public Screen {
 public:
  explicit Choose(Desk& d) : Screen(d), first_(std::max(d.card, 0)) {}
  ScreenId id() const override { return ScreenId::choose; }
  std::string first_focus() const override {
    return open_ < 0 ? "choose.card." + std::to_string(first_) : "choose.throw";
  }

  void press(const std::string& control) override {
    desk.turned = true;
    const std::string card = "choose.card.";
    if (control.starts_with(card)) {
      open(std::stoi(control.substr(card.size())));
    } else if (control == "choose.alike") {
      open(alike_);
    } else if (control == "choose.next") {
      first_ = (page_ + 1) * per_page_;
    } else if (control == "choose.previous") {
      first_ = std::max(0, page_ - 1) * per_page_;
    } else if (control == "choose.more") {
      part_ = parts_ > 1 ? (part_ + 1) % parts_ : 0;
    } else if (control == "choose.throw") {
      desk.card = open_;
      desk.start_pot(open_, false);
      desk.go(ScreenId::throwing);
    }
  }

  void back() override {
    if (open_ < 0) return desk.go(ScreenId::attract);
    first_ = open_;
    open_ = -1;
    desk.turned = true;
  }

  void lay_out(Page& page) override { open_ < 0 ? lay_out_shelf(page) : lay_out_label(page); }

 private:
  void lay_out_shelf(Page& page) {
    const TypeScale& t = page.type();
    Column column(page, page.where().page);
    column.text(desk.say("choose.title"), t.title, Face::serif);
    column.text(desk.say(desk.cards() > 0 ? "choose.lead" : "choose.empty"), t.body, Face::sans,
                view::kFaintInk);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 1.5f);
    column.space(t.gap * 1.5f);
    if (desk.cards() == 0) return;

    // How many cards a row holds follows from the type; how many rows, from what is left.
    const float gap = t.body * 1.2f;
    const Rect whole = column.rest();
    const float narrowest = t.body * (page.where().portrait ? 10.5f : 11.0f);
    const int columns = std::clamp(static_cast<int>((whole.w + gap) / (narrowest + gap)), 1,
                                   std::max(1, desk.cards()));
    const float card_width =
        (whole.w - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    float text_height = 0;
    for (int i = 0; i < desk.cards(); ++i)
      text_height = std::max(text_height, card_text(page, i, {0, 0, card_width, 0}, false));

    const auto rows_in = [&](float height) {
      return static_cast<int>((height + gap) / (t.body * 6.5f + text_height + gap));
    };
    int rows = std::max(1, rows_in(whole.h));
    if (rows * columns < desk.cards()) {
      // The line of paging may take a row: what is on a page is known once it has been laid out.
      page_ = first_ / per_page_;
      paging(page, column, per_page_);
      rows = std::max(1, rows_in(column.rest().h));
    }
    const Rect area = column.rest();
    if (std::exchange(per_page_, rows * columns) != rows * columns) page.restart();
    page_ = first_ / per_page_;
    // Few vessels on a tall screen: fewer rows with larger pictures.
    rows = std::min(rows, (desk.cards() + columns - 1) / columns);

    const float row_height =
        (area.h - gap * static_cast<float>(rows - 1)) / static_cast<float>(rows);
    const float picture = row_height - text_height - t.gap * 0.5f;
    if (picture < t.body * 3) page.overflowed();
    const int last = std::min(desk.cards(), (page_ + 1) * per_page_);
    for (int i = page_ * per_page_; i < last; ++i) {
      const int k = i - page_ * per_page_;
      const auto c = static_cast<float>(k % columns), r = static_cast<float>(k / columns);
      const Rect card{area.x + c * (card_width + gap), area.y + r * (row_height + gap), card_width,
                      row_height};
      page.control("choose.card." + std::to_string(i), card);
      const ShelfCard* shelf = desk.shelf_card(i);
      const float inset = t.gap * 0.5f;
      if (shelf->picture != 0)
        page.draw(
            view::Picture{{card.x + inset, card.y + inset, card.w - 2 * inset, picture - inset},
                          shelf->picture,
                          1});
      card_text(page, i, {card.x, card.y + picture + t.gap * 0.5f, card.w, text_height}, true);
    }
  }

  /// Title in cobalt with its hairline, culture and date; gives the height. Draws when asked to.
  float card_text(Page& page, int index, const Rect& at, bool draw) const {
    const TypeScale& t = page.type();
    const content::Label label = desk.label(index);
    float y = at.y;
    const auto line = [&](const std::string& words, Face face, float px, view::Color color) {
      if (words.empty()) return;
      auto style = page.style(face, px, view::Align::centre);
      style.line_height = 1.25f;
      const auto size = page.size(words, style, at.w);
      if (size.width > at.w + 2) page.overflowed();
      if (draw) page.words({at.x, y, at.w, size.height}, words, style, color);
      y += size.height;
    };
    line(label.title, Face::serif, t.body * 1.12f, view::kCobalt);
    line(label.culture, Face::sans, t.body * 0.94f, view::kFaintInk);
    line(label.date, Face::sans, t.body * 0.94f, view::kFaintInk);
    return y - at.y + t.gap * 0.5f;
  }

  /// "Earlier", "2 of 4", "More vessels": beside Back and Help where there is room, else above.
  void paging(Page& page, Column& column, int per_page) {
    const TypeScale& t = page.type();
    const int pages = (desk.cards() + per_page - 1) / per_page;
    std::vector<Button> row;
    if (page_ > 0) row.push_back({"choose.previous", desk.say("choose.previous"), Look::outline});
    if (page_ + 1 < pages) row.push_back({"choose.next", desk.say("choose.next"), Look::outline});
    const std::string count = desk.say(
        "choose.page", {{"page", std::to_string(page_ + 1)}, {"pages", std::to_string(pages)}});
    const auto style = page.style(Face::sans, t.body);
    const auto count_size = page.size(count, style, -1);

    const Rect whole = page.where().page;
    float used = 0, height = t.target;
    for (const Control& c : page.controls()) used = std::max(used, c.rect.x + c.rect.w - whole.x);
    float wanted = count_size.width + 4;
    for (const Button& b : row) {
      const auto size = page.size(b, whole.w);
      wanted += size.width + t.gap;
      height = std::max(height, size.height);
    }
    float y = whole.y + whole.h - height;
    if (used + wanted + t.gap * 3 > whole.w) {
      y = column.rest().y + column.rest().h - height;
      column.foot_space(height + t.gap * 1.5f);
    }
    float x = whole.x + whole.w - wanted;
    page.words({x, y + (height - count_size.height) / 2, count_size.width + 4, count_size.height},
               count, style, view::kFaintInk);
    x += count_size.width + 4 + t.gap;
    for (const Button& b : row) {
      const auto size = page.size(b, whole.w);
      page.button(b, {x, y, size.width, height});
      x += size.width + t.gap;
    }
  }

  /// The label of `card`; which other vessel is most like it is asked once.
  void open(int card) {
    open_ = card;
    part_ = 0;
    parts_ = 1;
    alike_ = -1;
    const ShelfCard* shelf = desk.shelf_card(card);
    if (shelf == nullptr) return;
    std::vector<const Profile*> others;
    for (int i = 0; i < desk.cards(); ++i) others.push_back(&desk.shelf_card(i)->target);
    if (const auto found = score::most_alike(shelf->target, others))
      alike_ = static_cast<int>(*found);
  }

  void lay_out_label(Page& page) {
    const ShelfCard* shelf = desk.shelf_card(open_);
    if (shelf == nullptr) return;
    const TypeScale& t = page.type();
    Rect words = page.where().words, picture = page.where().pot;
    if (page.where().portrait) {
      const float more = words.h * 0.2f;
      words.y -= more;
      words.h += more;
      picture.h -= more;
      picture.x = words.x;  // its credit and code stand above the words
      picture.w = words.w;
    } else {
      // A label needs longer lines than a hint: half the page.
      const Rect whole = page.where().page;
      words.w = std::round(whole.w * 0.52f);
      picture = {words.x + words.w + page.type().margin, whole.y, whole.w - words.w - t.margin,
                 whole.h};
      if (page.where().mirrored) {
        picture.x = whole.x;
        words.x = whole.x + whole.w - words.w;
      }
    }
    const content::Label label = desk.label(open_);
    lay_out_picture(page, *shelf, label, picture);

    Column column(page, words);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 1.5f);
    const bool several = parts_ > 1;
    std::vector<Button> onward{{"choose.throw", desk.say("choose.throw"), Look::solid}};
    if (several)
      onward.push_back({"choose.more",
                        desk.say(part_ + 1 < parts_ ? "choose.more" : "choose.first"),
                        Look::outline});
    if (alike_ >= 0)
      onward.push_back({"choose.alike",
                        desk.say("choose.alike", {{"vessel", desk.label(alike_).title}}),
                        Look::quiet});
    column.foot_buttons(onward);
    column.foot_space(t.gap * 1.5f);
    column.text(label.title, t.title, Face::serif);
    std::string line = label_line(label);
    if (shelf->vessel->true_height > 0) {
      const std::string size =
          desk.say("choose.size", {{"cm", centimetres(shelf->vessel->true_height)}});
      line += (line.empty() ? "" : ". ") + size;
      // A vessel is worked at a size that a hand can reach, and the label says which.
      if (const int percent = percent_of_size(*shelf); percent != 100)
        line += ". " + desk.say(percent < 100 ? "choose.reduced" : "choose.enlarged",
                                {{"percent", std::to_string(percent)}});
    }
    column.text(line, t.body, Face::sans, view::kFaintInk);
    column.space(t.gap);

    const auto style = page.style(Face::sans, t.body);
    const auto parts = parts_that_fit(page, {label.text, label.made}, style, column.rest());
    part_ = std::clamp(part_, 0, static_cast<int>(parts.size()) - 1);
    bool first = true;
    for (const std::string& paragraph : parts[static_cast<std::size_t>(part_)]) {
      if (!std::exchange(first, false)) column.space(paragraph_gap(style));
      column.text(paragraph, t.body);
    }
    if ((parts.size() > 1) != several) {
      // "Read on" appears or goes: once more with it in the reckoning.
      parts_ = static_cast<int>(parts.size());
      page.restart();
    }
    parts_ = static_cast<int>(parts.size());
  }

  /// The vessel, and under it whose picture it is; beside that, for a phone, the museum's page.
  void lay_out_picture(Page& page, const ShelfCard& shelf, const content::Label& label, Rect room) {
    const TypeScale& t = page.type();
    const std::string& credit = label.credit.empty() ? shelf.vessel->credit : label.credit;
    if (std::exchange(coded_, label.address) != label.address)
      code_ = view::SquareCode(label.address);
    const float wanted = t.body * 5.5f, side = code_.width(wanted);
    const auto style =
        page.style(Face::sans, t.body, code_.empty() ? view::Align::centre : view::Align::start);
    struct Line {
      std::string words;
      view::Color color;
      float height;
    };
    std::vector<Line> lines;
    float height = 0;
    const auto add = [&](const std::string& words, view::Color color) {
      if (words.empty()) return;
      const auto size = page.size(words, style, room.w - side);
      if (size.width > room.w - side + 2) page.overflowed();
      lines.push_back({words, color, size.height});
      height += size.height;
    };
    add(credit, view::kFaintInk);
    if (!code_.empty()) {
      add(desk.say("choose.page_of"), view::kInk);
      add(content::short_address(label.address), view::kInk);
    }
    const float strip = std::max(height, side);
    if (strip > 0) room.h -= strip + t.gap;
    if (room.h < t.body * 4) page.overflowed();
    const float top = room.y + room.h + t.gap;
    const bool from_right = desk.words().right_to_left();
    code_.draw(page.items(), from_right ? room.x + room.w - side : room.x, top + (strip - side) / 2,
               wanted);
    float y = top + (strip - height) / 2;
    for (const Line& line : lines) {
      page.words({from_right ? room.x : room.x + side, y, room.w - side, line.height}, line.words,
                 style, line.color);
      y += line.height;
    }
    if (shelf.picture != 0) page.draw(view::Picture{room, shelf.picture, 1});
  }

  std::string coded_;      ///< The address that code_ is of.
  view::SquareCode code_;  ///< Reckoned once for a label, not once a frame.
  int first_ = 0;          ///< A card of the page shown.
  int page_ = 0, per_page_ = 1;
  int open_ = -1, part_ = 0, parts_ = 1;
  int alike_ = -1;  ///< The card whose shape is most like the open one's; -1: none is alike.
};

}  // namespace

std::unique_ptr<Screen> make_choose(Desk& desk) { return std::make_unique<Choose>(desk); }

}  // namespace onggi::screens
