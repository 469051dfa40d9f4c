#include "kiosk/screens/result_screen.h"

#include "kiosk/screens/overlays.h"
#include "kiosk/screens/pot_picture.h"
#include "kiosk/screens/side_by_side.h"

namespace onggi::screens {

using view::Face;

namespace {

constexpr std::size_t kMostRemarks = 2;  // Of each kind: more is not read.

/// Stars and words: what is alike, what to try; and the vessel beside the pot.
class Result final : public Screen {
 public:
  explicit Result(Desk& d) : Screen(d), both_(d) {}
  ScreenId id() const override { return ScreenId::result; }
  std::string first_focus() const override { return "result.keep"; }

  void update(double dt) override {
    picture_.update(desk, dt, nullptr, false, false);
    both_.update(desk, dt);
  }
  std::optional<view::PotView> pot(const Page& page) override {
    return both_.view(picture_.view(desk, page), desk);
  }
  void pointer(const view::InputEvent& e, const Page&) override { both_.pointer(e); }

  void lay_out(Page& page) override {
    both_.lay_out(page, desk);
    const TypeScale& t = page.type();
    Column column(page, page.where().words);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 1.5f);
    const std::string on = desk.wheel().kiln ? desk.say("result.fire") : desk.say("result.keep");
    column.foot_buttons({{"result.keep", on, Look::solid},
                         {"result.again", desk.say("result.again"), Look::outline},
                         {"result.other", desk.say("result.other"), Look::outline}});
    column.foot_space(t.gap);

    const std::string stars = std::to_string(desk.score.stars);
    column.text(desk.say("result.answer", {{"vessel", desk.label(desk.card).title}}), t.body,
                Face::sans, view::kFaintInk);
    column.space(t.gap * 0.5f);
    column.text(desk.say("result.title_" + stars), t.title, Face::serif);
    column.space(t.gap);
    column.circles(desk.score.stars, 5, desk.say("result.stars", {{"stars", stars}}));
    column.space(t.gap);
    remarks(column, t, "result.alike", desk.score.alike);
    if (!desk.score.try_next.empty()) column.space(t.gap);
    remarks(column, t, "result.try", desk.score.try_next);
  }

  void press(const std::string& control) override {
    if (control == "result.keep") {
      if (!desk.wheel().kiln) desk.keep_pot();
      desk.go(desk.wheel().kiln ? ScreenId::kiln : ScreenId::keepsake);
    } else if (control == "result.again") {
      desk.start_pot(desk.card, false);
      desk.go(ScreenId::throwing);
    } else if (control == "result.other") {
      desk.go(ScreenId::choose);
    }
  }
  void back() override { desk.go(ScreenId::throwing); }

 private:
  void remarks(Column& column, const TypeScale& t, const std::string& heading,
               const std::vector<score::Remark>& all) const {
    if (all.empty()) return;
    column.text(desk.say(heading), t.body, Face::serif, view::kFaintInk);
    for (std::size_t i = 0; i < std::min(all.size(), kMostRemarks); ++i)
      column.text(desk.say(all[i].key, all[i].places), t.body);
  }

  PotPicture picture_;
  SideBySide both_;
};

}  // namespace

std::unique_ptr<Screen> make_result(Desk& desk) { return std::make_unique<Result>(desk); }

}  // namespace onggi::screens
