#include "kiosk/visit/screens/fault_screen.h"

#include "kiosk/visit/screens/overlays.h"

namespace onggi::screens {

using view::Face;

namespace {

/// Kind words for the visitor; the cause is in the log for staff.
class Fault final : public Screen {
 public:
  using Screen::Screen;
  ScreenId id() const override { return ScreenId::fault; }
  std::string first_focus() const override { return "fault.on"; }

  void lay_out(Page& page) override {
    const TypeScale& t = page.type();
    const Rect whole = page.where().page;
    Column column(page, whole);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 2);
    column.space(whole.h * 0.16f);
    column.text(desk.say("fault.title"), t.title, Face::serif);
    column.space(t.gap);
    column.text(desk.say("fault.text"), t.body);
    column.space(t.gap * 2);
    column.buttons({{"fault.on", desk.say("fault.on"), Look::solid}});
  }

  void press(const std::string& control) override {
    if (control == "fault.on") back();
  }
  void back() override { desk.go(ScreenId::attract); }
  void pointer(const view::InputEvent& e, const Page&) override {
    if (e.kind == view::InputEvent::Kind::pointer_up) back();
  }

 private:
  using Rect = view::Rect;
};

}  // namespace

std::unique_ptr<Screen> make_fault(Desk& desk) { return std::make_unique<Fault>(desk); }

}  // namespace onggi::screens
