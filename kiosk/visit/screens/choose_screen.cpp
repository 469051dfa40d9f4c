#include "kiosk/visit/screens/choose_screen.h"

#include <optional>
#include <utility>

#include "kiosk/visit/screens/card_shelf.h"
#include "kiosk/visit/screens/label.h"
#include "kiosk/visit/screens/overlays.h"
#include "kiosk/visit/screens/vessel_label.h"

namespace onggi::screens {

using view::Face;
using view::Rect;

namespace {

/// The shelf, with the label of the touched vessel over it.
class Choose final : public Screen, private CardShelf::Cards {
 public:
  explicit Choose(Desk& d)
      : Screen(d), label_(d), shelf_(d, *this, "choose", place_of(d.card, d.mission)) {
    if (const auto offered = std::exchange(d.offered, {}))
      label_.open(offered->card, offered->mission);
  }
  ScreenId id() const override { return ScreenId::choose; }
  std::string first_focus() const override {
    if (!open()) return control(shelf_.in_front());
    return label_.offers_to_build() ? "choose.build" : "choose.throw";
  }

  void update(double dt) override { shelf_.update(dt); }

  void press(const std::string& control) override {
    if (shelf_.press(control)) return;
    desk.turned = true;
    if (const auto place = place_of(control)) {
      if (*place < desk.missions())
        label_.open(desk.mission_card(*place).card, *place);
      else
        label_.open(*place - desk.missions());
    } else if (label_.press(control)) {
      return;
    } else if (control == "choose.throw" || control == "choose.build") {
      desk.built = control == "choose.build";
      desk.card = label_.card();
      desk.mission = label_.mission();
      desk.start_pot(label_.card(), false);
      desk.go(ScreenId::throwing);
    }
  }

  void back() override {
    if (!open()) return desk.go(ScreenId::attract);
    shelf_.want(place_of(label_.card(), label_.mission()));
    label_.close();
    desk.turned = true;
  }

  void let_go() override { shelf_.let_go(); }
  bool drag(const view::InputEvent& e, const Page&) override { return !open() && shelf_.drag(e); }
  void pointer(const view::InputEvent& e, const Page&) override {
    if (open()) return;
    if (const std::string nearer = shelf_.pointer(e); !nearer.empty()) press(nearer);
  }
  std::string step(const std::string& from, Direction to) override {
    const auto place = place_of(from);
    const int next = open() || !place ? -1 : shelf_.step(*place, to);
    return next < 0 ? std::string() : control(next);
  }

  void lay_out(Page& page) override { open() ? label_.lay_out(page) : lay_out_shelf(page); }

 private:
  bool open() const { return label_.card() != -1; }
  // Missions come before the vessels.
  int place_of(int card, int mission) const {
    return mission >= 0 ? mission : card < 0 ? 0 : desk.missions() + card;
  }
  std::optional<int> place_of(const std::string& control) const {
    const std::string card = "choose.card.", mission = "choose.mission.";
    if (control.starts_with(mission)) return std::stoi(control.substr(mission.size()));
    if (!control.starts_with(card)) return std::nullopt;
    return desk.missions() + std::stoi(control.substr(card.size()));
  }
  /// The card at `place`, from the shelf or a mission.
  int card_at(int place) const {
    return place < desk.missions() ? desk.mission_card(place).card : place - desk.missions();
  }

  int count() const override { return desk.missions() + desk.cards(); }
  view::PictureId picture(int i) const override {
    const ShelfCard* card = desk.shelf_card(card_at(i));
    return card != nullptr ? card->picture : 0;
  }
  std::string spoken(int i) const override {
    const content::Label label = desk.label(card_at(i));
    std::string name = label.title;
    if (i < desk.missions()) {
      const MissionCard& mission = desk.mission_card(i);
      name = desk.say("mission.card") + ", " + mission.mission->title_in(desk.words().code());
      return mission_of_own(mission.card) < 0 ? name + ", " + label.title : name;
    }
    for (const std::string& more : {label.what, label.culture, label.date})
      if (!more.empty()) name += ", " + more;
    return name;
  }
  std::string control(int i) const override {
    return i < desk.missions() ? "choose.mission." + std::to_string(i)
                               : "choose.card." + std::to_string(i - desk.missions());
  }

  void lay_out_shelf(Page& page) {
    const TypeScale& t = page.type();
    Column column(page, page.where().page);
    column.text(desk.say("choose.title"), t.title, Face::serif);
    column.text(desk.say(count() > 0 ? "choose.lead" : "choose.empty"), t.body, Face::sans,
                view::kFaintInk);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 1.5f);
    column.space(t.gap * 1.5f);
    shelf_.lay_out(page, column);
  }

  /// Title in cobalt; then what a vessel is and its culture, or the word for a mission and its
  /// vessel.
  float words(Page& page, int index, const Rect& at, float opacity) const override {
    const TypeScale& t = page.type();
    const content::Label label = desk.label(card_at(index));
    CardWords lines(page, at, opacity);
    if (index < desk.missions()) {
      const MissionCard& mission = desk.mission_card(index);
      lines.add(mission.mission->title_in(desk.words().code()), Face::serif, t.body * 1.12f,
                view::kCobalt);
      lines.add(desk.say("mission.card"), Face::sans, t.body, view::kFaintInk);
      if (mission_of_own(mission.card) < 0)
        lines.add(label.title, Face::sans, t.body, view::kFaintInk);
      return lines.height();
    }
    lines.add(label.title, Face::serif, t.body * 1.12f, view::kCobalt);
    for (const std::string& line : under_title(label))
      lines.add(line, Face::sans, t.body, view::kFaintInk);
    return lines.height();
  }

  VesselLabel label_;
  CardShelf shelf_;
};

}  // namespace

std::unique_ptr<Screen> make_choose(Desk& desk) { return std::make_unique<Choose>(desk); }

}  // namespace onggi::screens
