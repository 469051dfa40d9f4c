#include "kiosk/screens/keepsake_screen.h"

#include <algorithm>
#include <utility>

#include "kiosk/screens/gallery_page.h"
#include "kiosk/screens/overlays.h"
#include "kiosk/view/square_code.h"

namespace onggi::screens {

using view::Face;
using view::Rect;

namespace {

/// The postcard, large, and where it is kept; from there today's pots.
class Keepsake final : public Screen {
 public:
  explicit Keepsake(Desk& d) : Screen(d), gallery_(d) {}
  ScreenId id() const override { return ScreenId::keepsake; }
  std::string first_focus() const override { return "keepsake.done"; }

  void update(double dt) override {
    gallery_.update(dt);
    if (open_ && !gallery_.any()) turn_to(false);
  }
  bool drag(const view::InputEvent& e, const Page& page) override {
    return open_ && gallery_.drag(e, page);
  }
  void pointer(const view::InputEvent& e, const Page&) override {
    if (open_) gallery_.pointer(e);
  }
  void let_go() override { gallery_.let_go(); }

  void lay_out(Page& page) override {
    const Button done{"keepsake.done", desk.say("keepsake.done"), Look::solid};
    if (open_) return gallery_.lay_out(page, {done}, true);
    if (desk.postcard != 0) lay_out_card(page);
    const TypeScale& t = page.type();
    Column column(page, page.where().words);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 1.5f);
    std::vector<Button> ways{done, {"keepsake.again", desk.say("keepsake.again"), Look::outline}};
    if (gallery_.any()) ways.push_back(gallery_.way("keepsake.gallery"));
    column.foot_buttons(ways);
    column.foot_space(t.gap);
    const bool failed = desk.kept == Desk::Kept::failed;
    const bool making = desk.postcard == 0 && !failed;
    column.text(making            ? desk.say("keepsake.making")
                : desk.glaze >= 0 ? desk.say("keepsake.title")
                                  : desk.say("keepsake.unfired"),
                t.title, Face::serif);
    column.space(t.gap);
    switch (desk.kept) {
      case Desk::Kept::not_asked:
      case Desk::Kept::asked:
        column.text(desk.say("keepsake.wait"), t.body);
        break;
      case Desk::Kept::kept:
        column.text(desk.say("keepsake.kept"), t.body);
        column.space(t.gap);
        // Date and time stay in their order among words from the right, too.
        column.text(
            desk.words().right_to_left() ? "\u2066" + desk.kept_as + "\u2069" : desk.kept_as,
            t.body, Face::sans, view::kFaintInk);
        lay_out_code(column);
        break;
      case Desk::Kept::failed:
        column.text(desk.say("keepsake.failed"), t.body);
        break;
    }
  }

  void press(const std::string& control) override {
    if (control == "keepsake.done") desk.go(ScreenId::attract);
    if (control == "keepsake.again") desk.go(ScreenId::choose);
    if (control == "keepsake.gallery") turn_to(true);
    if (open_) gallery_.press(control);
  }
  void back() override {
    if (open_) return turn_to(false);
    desk.go(desk.wheel().kiln ? ScreenId::kiln : ScreenId::result);
  }

 private:
  void turn_to(bool open) {
    open_ = open;
    gallery_.begin();
    desk.turned = true;
  }

  /// For a phone, where one can reach it.
  void lay_out_code(Column& column) {
    Page& page = column.page();
    if (std::exchange(coded_, desk.kept_at) != desk.kept_at) code_ = view::SquareCode(desk.kept_at);
    if (code_.empty()) return;
    const TypeScale& t = page.type();
    column.space(t.gap);
    column.text(desk.say("keepsake.phone"), t.body);
    // Its own quiet zone is air enough.
    const float wanted = t.body * 7, side = code_.width(wanted);
    const view::Rect room = column.rest();
    if (side > room.h || side > room.w) return page.overflowed();
    const float x = desk.words().right_to_left() ? room.x + room.w - side : room.x;
    code_.draw(page.items(), x, room.y, wanted);
  }

  GalleryPage gallery_;
  bool open_ = false;      ///< The gallery is shown.
  std::string coded_;      ///< The address that code_ is of.
  view::SquareCode code_;  ///< Reckoned once for a page.

  /// A card of 5:7 lying on the plaster: a soft shadow laid in films, no frame.
  void lay_out_card(Page& page) const {
    const Rect room = page.where().pot;
    const float h = std::min(room.h, room.w * 1.4f), w = h / 1.4f;
    const Rect card{room.x + (room.w - w) / 2, room.y + (room.h - h) / 2, w, h};
    constexpr int kFilms = 14;
    for (int i = 1; i <= kFilms; ++i) {
      const float grow = page.type().body * 0.06f * static_cast<float>(i);
      page.draw(view::Box{{card.x - grow, card.y - grow + page.type().body * 0.3f,
                           card.w + 2 * grow, card.h + 2 * grow},
                          grow,
                          view::with_alpha(view::kInk, 0.009f),
                          0,
                          {}});
    }
    page.draw(view::Picture{card, desk.postcard, 1});
  }
};

}  // namespace

std::unique_ptr<Screen> make_keepsake(Desk& desk) { return std::make_unique<Keepsake>(desk); }

}  // namespace onggi::screens
