#include "kiosk/visit/screens/result_screen.h"

#include <algorithm>
#include <span>

#include "kiosk/collection/score/in_words.h"
#include "kiosk/visit/screens/onward.h"
#include "kiosk/visit/screens/overlays.h"
#include "kiosk/visit/screens/pot_picture.h"
#include "kiosk/visit/screens/side_by_side.h"
#include "kiosk/visit/screens/turntable.h"

namespace onggi::screens {

using view::Face;

namespace {

constexpr std::size_t kMostRemarks = 2;  // of each kind: visitors do not read more
constexpr double kAlone = 0.5;           // rad/s of a pot that turns for show
constexpr const char* kTurn = "result.turn";

/// Stars and words: what is alike, what to try; and the vessel beside the pot. Figures only for
/// those who ask. A description has no vessel: the pot's figures, and the pot alone. Visitors can
/// turn the pots.
class Result final : public Screen {
 public:
  explicit Result(Desk& d) : Screen(d), onward_(onward_from(d)) {
    if (d.described() == nullptr) both_.emplace(d);
  }
  ScreenId id() const override { return ScreenId::result; }
  std::string first_focus() const override { return "result.keep"; }

  void update(double dt) override {
    picture_.update(desk, dt, nullptr, false, false);
    if (both_) both_->update(desk, table_, dt);
    if (!both_) picture_.show_round(desk, dt, table_.stands(desk.now) ? 0.0 : own_speed());
  }
  std::optional<view::PotView> pot(const Page& page) override {
    if (both_) return both_->view(picture_.view(desk, page), desk, table_);
    view::PotView pot = picture_.view(desk, page);
    pot.hands = {};
    pot.clay_angle += table_.angle();
    pot.wheel_angle += table_.angle();
    pot.camera.elevation += table_.tilt();
    return pot;
  }
  bool more_fingers() const override { return true; }
  void let_go() override { table_.let_go(); }
  void pointer(const view::InputEvent& e, const Page& page) override {
    const float half_turn = both_ ? both_->half_turn() : 0.5f * page.where().pot.w;
    if (!table_.pair(e, half_turn)) table_.pointer(e, half_turn);
  }
  std::string step(const std::string& from, Direction to) override {
    if (from != kTurn || to == Direction::up || to == Direction::down) return {};
    table_.by_arrow(to == Direction::right);
    return from;
  }

  void lay_out(Page& page) override {
    if (both_) both_->lay_out(page, desk, said());
    const view::Rect& room = both_ ? both_->room() : page.where().pot;
    const std::string arrows = desk.screen().one_switch ? "" : desk.say("result.turn_how");
    page.control({kTurn, room, desk.say("result.turn"), {}, arrows, true});
    table_.keyed(page.focused(kTurn));
    const TypeScale& t = page.type();
    Column column(page, page.where().words);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 1.5f);
    const std::string on = desk.say(decorates()          ? "result.decorate"
                                    : !desk.wheel().kiln ? "result.keep"
                                    : desk.glaze < 0     ? "result.fire"
                                                         : "result.fired");
    std::vector<Button> ways{{"result.keep", on, Look::solid}};
    if (onward_) ways.push_back({"result.onward", onward_->words(desk), Look::outline});
    ways.push_back({"result.again", desk.say("result.again"), Look::outline});
    ways.push_back({"result.other", desk.say("result.other"), Look::outline});
    column.foot_buttons(ways);
    column.foot_space(t.gap);

    const std::string stars = std::to_string(desk.score.stars);
    column.text(desk.answer(), t.body, Face::sans, view::kFaintInk);
    column.space(t.gap * 0.5f);
    column.text(desk.say((both_ ? "result.title_" : "mission.title_") + stars), t.title,
                Face::serif);
    column.space(t.gap);
    column.stars(desk.score.stars, desk.say("result.stars", {{"stars", stars}}));
    column.space(t.gap);
    remarks(column, t, "mission.asked", desk.score.asked, desk.score.asked.size());
    if (both_ && !desk.exactly) {
      for (const auto* all : {&desk.score.alike, &desk.score.try_next})
        if (!all->empty()) column.text(desk.said(score::in_words(all->front())), t.lead);
    } else {
      remarks(column, t, "result.alike", desk.score.alike);
      if (!desk.score.try_next.empty()) column.space(t.gap);
      remarks(column, t, both_ ? "result.try" : "mission.try", desk.score.try_next);
    }
    if (both_)
      column.buttons({{"result.figures", desk.say(desk.exactly ? "result.words" : "result.figures"),
                       Look::quiet}});
  }

  void press(const std::string& control) override {
    if (control == "result.keep") {
      if (decorates()) return desk.go(ScreenId::decorate);
      if (!desk.wheel().kiln) desk.keep_pot();
      desk.go(desk.wheel().kiln ? ScreenId::kiln : ScreenId::keepsake);
    } else if (control == "result.again") {
      desk.start_pot(desk.card, false);
      desk.go(ScreenId::throwing);
    } else if (control == "result.other") {
      desk.go(ScreenId::choose);
    } else if (control == "result.onward" && onward_) {
      desk.offered = onward_->of;
      desk.go(ScreenId::choose);
    } else if (control == "result.figures") {
      desk.exactly = !desk.exactly;
      desk.turned = true;
    } else if (control == kTurn) {
      table_.press(own_speed(), desk.now);
    }
  }
  void back() override { desk.go(ScreenId::throwing); }
  bool leaves_pot(const std::string& control) const override {
    return control == "result.again" || control == "result.other" || control == "result.onward";
  }
  std::vector<std::string> help() const override {
    return {desk.say(both_ ? help_key() : "help.result_measured")};
  }

 private:
  /// What the words ask to try.
  std::span<const score::Remark> said() const {
    const auto& all = desk.score.try_next;
    return {all.data(), std::min(all.size(), desk.exactly ? kMostRemarks : 1)};
  }
  /// A pot that is fired is decorated no more.
  bool decorates() const { return desk.wheel().way != nullptr && desk.glaze < 0; }
  double own_speed() const { return desk.screen().left_handed ? -kAlone : kAlone; }
  void remarks(Column& column, const TypeScale& t, const std::string& heading,
               const std::vector<score::Remark>& all, std::size_t most = kMostRemarks) const {
    if (all.empty()) return;
    column.text(desk.say(heading), t.body, Face::serif, view::kFaintInk);
    for (std::size_t i = 0; i < std::min(all.size(), most); ++i)
      column.text(desk.said(all[i]), t.body);
  }

  std::optional<Onward> onward_;
  PotPicture picture_;
  Turntable table_;
  std::optional<SideBySide> both_;  ///< Absent if there was no vessel to copy.
};

}  // namespace

std::unique_ptr<Screen> make_result(Desk& desk) { return std::make_unique<Result>(desk); }

}  // namespace onggi::screens
