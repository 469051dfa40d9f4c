#include "kiosk/screens/choose_screen.h"

#include <algorithm>
#include <optional>

#include "kiosk/screens/card_shelf.h"
#include "kiosk/screens/overlays.h"
#include "kiosk/screens/vessel_label.h"

namespace onggi::screens {

using view::Face;
using view::Rect;

namespace {

/// The shelf, and over it the label of the vessel that was touched.
class Choose final : public Screen, private CardShelf::Cards {
 public:
  explicit Choose(Desk& d)
      : Screen(d), label_(d), shelf_(d, *this, "choose", std::max(d.card, 0)) {}
  ScreenId id() const override { return ScreenId::choose; }
  std::string first_focus() const override {
    return !open() ? control(shelf_.in_front()) : "choose.throw";
  }

  void update(double dt) override { shelf_.update(dt); }

  void press(const std::string& control) override {
    if (shelf_.press(control)) return;
    desk.turned = true;
    if (const auto card = card_of(control)) {
      label_.open(*card);
    } else if (label_.press(control)) {
      return;
    } else if (control == "choose.throw") {
      desk.card = label_.card();
      desk.start_pot(label_.card(), false);
      desk.go(ScreenId::throwing);
    }
  }

  void back() override {
    if (!open()) return desk.go(ScreenId::attract);
    shelf_.want(label_.card());
    label_.close();
    desk.turned = true;
  }

  void let_go() override { shelf_.let_go(); }
  bool drag(const view::InputEvent& e, const Page& page) override {
    return !open() && shelf_.drag(e, page);
  }
  void pointer(const view::InputEvent& e, const Page&) override {
    if (!open()) shelf_.pointer(e);
  }
  std::string step(const std::string& from, Direction to) override {
    const auto card = card_of(from);
    const int next = open() || !card ? -1 : shelf_.step(*card, to);
    return next < 0 ? std::string() : control(next);
  }

  void lay_out(Page& page) override { open() ? label_.lay_out(page) : lay_out_shelf(page); }

 private:
  bool open() const { return label_.card() >= 0; }
  static std::optional<int> card_of(const std::string& control) {
    const std::string card = "choose.card.";
    if (!control.starts_with(card)) return std::nullopt;
    return std::stoi(control.substr(card.size()));
  }

  int count() const override { return desk.cards(); }
  view::PictureId picture(int i) const override { return desk.shelf_card(i)->picture; }
  std::string spoken(int i) const override {
    const content::Label label = desk.label(i);
    std::string name = label.title;
    for (const std::string& more : {label.culture, label.date})
      if (!more.empty()) name += ", " + more;
    return name;
  }
  std::string control(int i) const override { return "choose.card." + std::to_string(i); }

  void lay_out_shelf(Page& page) {
    const TypeScale& t = page.type();
    Column column(page, page.where().page);
    column.text(desk.say("choose.title"), t.title, Face::serif);
    column.text(desk.say(desk.cards() > 0 ? "choose.lead" : "choose.empty"), t.body, Face::sans,
                view::kFaintInk);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 1.5f);
    column.space(t.gap * 1.5f);
    shelf_.lay_out(page, column);
  }

  /// Title in cobalt, culture and date.
  float words(Page& page, int index, const Rect& at, float opacity) const override {
    const TypeScale& t = page.type();
    const content::Label label = desk.label(index);
    CardWords lines(page, at, opacity);
    lines.add(label.title, Face::serif, t.body * 1.12f, view::kCobalt);
    lines.add(label.culture, Face::sans, t.body * 0.94f, view::kFaintInk);
    lines.add(label.date, Face::sans, t.body * 0.94f, view::kFaintInk);
    return lines.height();
  }

  VesselLabel label_;
  CardShelf shelf_;
};

}  // namespace

std::unique_ptr<Screen> make_choose(Desk& desk) { return std::make_unique<Choose>(desk); }

}  // namespace onggi::screens
