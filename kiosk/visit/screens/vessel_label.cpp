#include "kiosk/visit/screens/vessel_label.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kiosk/collection/content/address.h"
#include "kiosk/collection/score/likeness.h"
#include "kiosk/visit/screens/label.h"
#include "kiosk/visit/screens/overlays.h"
#include "kiosk/visit/screens/stroke_board.h"

namespace onggi::screens {

using view::Face;
using view::Rect;

namespace {

/// The vessel's size on the wheel, relative to its true size.
int percent_of_size(const ShelfCard& card) {
  return static_cast<int>(std::lround(100.0 * card.scale));
}

}  // namespace

bool VesselLabel::press(const std::string& control) {
  if (control == "choose.more")
    part_ = parts_ > 1 ? (part_ + 1) % parts_ : 0;
  else if (control == "choose.alike")
    open(alike_);
  else
    return false;
  return true;
}

void VesselLabel::open(int card, int mission) {
  card_ = card;
  mission_ = mission;
  part_ = 0;
  parts_ = 1;
  alike_ = -1;
  const ShelfCard* shelf = desk_.shelf_card(card);
  if (shelf == nullptr || mission >= 0) return;
  std::vector<const Profile*> others;
  for (int i = 0; i < desk_.cards(); ++i) others.push_back(&desk_.shelf_card(i)->target);
  if (const auto found = score::most_alike(shelf->target, others))
    alike_ = static_cast<int>(*found);
}

void VesselLabel::lay_out(Page& page) {
  const ShelfCard* shelf = desk_.shelf_card(card_);
  if (shelf == nullptr) return;
  const TypeScale& t = page.type();
  Rect words = page.where().words, picture = page.where().pot;
  if (page.where().portrait) {
    const float more = words.h * 0.2f;
    words.y -= more;
    words.h += more;
    picture.h -= more;
    picture.x = words.x;  // its credit and code are above the words
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
  const content::Label label = desk_.label(card_);
  const settings::Mission* mission = mission_ >= 0 ? desk_.mission_card(mission_).mission : nullptr;
  lay_out_picture(page, *shelf, label, picture);

  Column column(page, words);
  column.foot_buttons(standing_buttons(desk_, true));
  column.foot_space(t.gap * 1.5f);
  const bool several = parts_ > 1;
  // In a row of its own below the others, so that it has one place on every label.
  column.foot_buttons(ways_to_make());
  column.foot_space(t.gap);
  std::vector<Button> onward;
  if (several) {
    const std::string more = desk_.say("choose.more"), first = desk_.say("choose.first");
    Button button{"choose.more", part_ + 1 < parts_ ? more : first, Look::outline};
    // Always reserve space for the longer words. Otherwise the last part has different space from
    // the first, and the number of parts changes with every frame.
    button.room =
        page.size(Button{"", more}, words.w).width < page.size(Button{"", first}, words.w).width
            ? first
            : more;
    onward.push_back(std::move(button));
  }
  if (alike_ >= 0)
    onward.push_back({"choose.alike",
                      desk_.say("choose.alike", {{"vessel", desk_.label(alike_).title}}),
                      Look::quiet});
  column.foot_buttons(onward);
  column.foot_space(t.gap * 1.5f);
  const std::string& code = desk_.words().code();
  column.text(mission != nullptr ? mission->title_in(code) : label.title, t.title, Face::serif);
  if (mission == nullptr) column.text(label.what, t.lead);
  std::string line = label_line(label, desk_.words());
  std::vector<std::string> paragraphs{label.text, label.made};
  if (mission != nullptr) {
    const bool two = mission->kind == settings::Mission::Kind::two_hands;
    const bool by_keys = two && mission->second == settings::Mission::Second::keys;
    if (two && StrokeBoard::wanted(desk_))
      paragraphs.insert(paragraphs.begin(), desk_.say("mission.by_buttons"));
    else if (by_keys)
      paragraphs.insert(paragraphs.begin(), desk_.say("mission.halves_keys"));
    paragraphs.insert(paragraphs.begin(), mission->about_in(code));
    if (mission_of_own(card_) < 0)
      line = line.empty() ? label.title
                          : desk_.say("all.sentences", {{"first", label.title}, {"second", line}});
  }
  if (shelf->vessel->true_height > 0) {
    const std::string size =
        desk_.say("choose.size", {{"cm", centimetres(shelf->vessel->true_height, desk_.words())}});
    const auto add = [&](const std::string& more) {
      line = line.empty() ? more : desk_.say("all.sentences", {{"first", line}, {"second", more}});
    };
    add(size);
    // The label tells the size if the vessel is scaled to what hands can reach.
    if (const int percent = percent_of_size(*shelf); percent != 100)
      add(desk_.say(percent < 100 ? "choose.reduced" : "choose.enlarged",
                    {{"percent", std::to_string(percent)}}));
    if (offers_to_build()) {
      const double coil = *shelf->built->coil;
      paragraphs.push_back(
          desk_.say("choose.coil", {{"mm", std::to_string(std::lround(1000 * coil))},
                                    {"cm", centimetres(coil / shelf->scale, desk_.words())}}));
    }
  }
  if (!line.empty()) column.text(line, t.body, Face::sans, view::kFaintInk);
  column.space(t.gap);

  const auto style = page.style(Face::sans, t.body);
  const auto parts = parts_that_fit(page, paragraphs, style, column.rest());
  part_ = std::clamp(part_, 0, static_cast<int>(parts.size()) - 1);
  bool first = true;
  for (const std::string& paragraph : parts[static_cast<std::size_t>(part_)]) {
    if (!std::exchange(first, false)) column.space(paragraph_gap(style));
    column.text(paragraph, t.body);
  }
  if ((parts.size() > 1) != several) {
    // "Read on" appears or disappears, so lay out again.
    parts_ = static_cast<int>(parts.size());
    page.restart();
  }
  parts_ = static_cast<int>(parts.size());
}

bool VesselLabel::offers_to_build() const {
  const ShelfCard* shelf = desk_.shelf_card(card_);
  return mission_ < 0 && shelf != nullptr && shelf->built && shelf->built->coil;
}

std::vector<Button> VesselLabel::ways_to_make() const {
  if (mission_ >= 0) return {{"choose.throw", desk_.say("mission.begin"), Look::solid}};
  if (!offers_to_build()) return {{"choose.throw", desk_.say("choose.throw"), Look::solid}};
  return {{"choose.build", desk_.say("choose.build"), Look::solid},
          {"choose.throw", desk_.say("choose.throw_it"), Look::outline}};
}

/// The vessel, the picture's credit below it, and beside the credit a code for a phone: the
/// museum's page.
void VesselLabel::lay_out_picture(Page& page, const ShelfCard& shelf, const content::Label& label,
                                  Rect room) {
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
    add(desk_.say("choose.page_of"), view::kInk);
    add(content::short_address(label.address), view::kInk);
  }
  const float strip = std::max(height, side);
  if (strip > 0) room.h -= strip + t.gap;
  if (room.h < t.body * 4) page.overflowed();
  const float top = room.y + room.h + t.gap;
  const bool from_right = desk_.words().right_to_left();
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

}  // namespace onggi::screens
