#include "kiosk/visit/screens/keepsake_screen.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "kiosk/collection/settings/wifi_code.h"
#include "kiosk/picture/view/square_code.h"
#include "kiosk/visit/screens/gallery_page.h"
#include "kiosk/visit/screens/overlays.h"

namespace onggi::screens {

using view::Face;
using view::Rect;

namespace {

/// Fewer visits are told nobody (kiosk/docs/store.md).
constexpr int kFew = 5;
// s that the thanks stand; the second where they are read aloud or a switch needs its time
constexpr double kThanks = 10, kThanksAided = 25;

/// The postcard, large, and the name under which it is kept; a button leads to today's pots. Who
/// has finished is thanked and sees the name once more, until a touch or for some seconds.
class Keepsake final : public Screen {
 public:
  explicit Keepsake(Desk& d) : Screen(d), gallery_(d) {}
  ScreenId id() const override { return ScreenId::keepsake; }
  std::string first_focus() const override { return "keepsake.done"; }

  void update(double dt) override {
    gallery_.update(dt);
    if (open_ && !gallery_.any()) turn_to(false);
    if (thanks_until_ && desk.now > *thanks_until_) desk.go(ScreenId::attract);
    if (leaves_ && !saving()) {
      leaves_ = false;
      if (desk.kept == Desk::Kept::kept) finish();
    }
  }
  bool drag(const view::InputEvent& e, const Page&) override { return open_ && gallery_.drag(e); }
  void pointer(const view::InputEvent& e, const Page&) override {
    if (open_) gallery_.pointer(e);
    if (thanks_until_ && e.kind == view::InputEvent::Kind::pointer_up) desk.go(ScreenId::attract);
  }
  void let_go() override { gallery_.let_go(); }

  void lay_out(Page& page) override {
    // Nobody is invited to go before they have read the name that the desk asks for.
    const Button done{"keepsake.done", desk.say("keepsake.done"),
                      saving() ? Look::outline : Look::solid};
    if (open_) return gallery_.lay_out(page, {done}, true);
    if (thanks_until_) return lay_out_thanks(page);
    if (desk.postcard != 0) lay_out_card(page);
    const TypeScale& t = page.type();
    Column column(page, page.where().words);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 1.5f);
    column.foot_buttons({done, {"keepsake.again", desk.say("keepsake.again"), Look::outline}});
    // It comes when the pot is kept, above the others: none of them moves under a finger.
    if (gallery_.any()) {
      column.foot_space(t.gap);
      column.foot_buttons({gallery_.way("keepsake.gallery")});
    }
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
        column.text(desk.say(desk.postcard == 0 ? "keepsake.wait" : "keepsake.naming"), t.body);
        break;
      case Desk::Kept::kept:
        column.text(desk.say("keepsake.kept"), t.body);
        column.space(t.gap);
        column.text(name(), t.title * 0.8f, Face::serif);
        if (const int n = number(); n >= kFew) {
          column.space(t.gap);
          column.text(desk.say("keepsake.today",
                               {{"vessel", desk.label(desk.card).title}, {"n", std::to_string(n)}}),
                      t.body, Face::sans, view::kFaintInk);
        }
        lay_out_codes(column);
        break;
      case Desk::Kept::failed:
        column.text(desk.say("keepsake.failed"), t.body);
        break;
    }
  }

  void press(const std::string& control) override {
    if (control == "keepsake.done") finish();
    if (control == "keepsake.again") desk.go(ScreenId::choose);
    if (control == "keepsake.gallery") turn_to(true);
    if (open_) gallery_.press(control);
  }
  void back() override {
    if (open_) return turn_to(false);
    if (thanks_until_) {
      thanks_until_.reset();
      desk.turned = true;
      return;
    }
    desk.go(desk.wheel().kiln             ? ScreenId::kiln
            : desk.wheel().way != nullptr ? ScreenId::decorate
                                          : ScreenId::result);
  }

 private:
  /// Which one of today's pots of its vessel this is; 0 where the exhibit does not show them.
  int number() const {
    return desk.world.todays == nullptr ? 0 : number_today(*desk.world.todays, desk.kept_in);
  }
  /// A name in another script keeps its order inside right-to-left text too.
  std::string name() const {
    return desk.words().right_to_left() ? "\u2068" + desk.kept_as + "\u2069" : desk.kept_as;
  }
  bool saving() const { return desk.kept == Desk::Kept::asked; }
  void finish() {
    // Who goes early is thanked as soon as the name is there. A second press goes at once.
    if (saving() && !std::exchange(leaves_, true)) return;
    if (thanks_until_ || desk.kept != Desk::Kept::kept) return desk.go(ScreenId::attract);
    const settings::Exhibit::Screen screen = desk.screen();
    thanks_until_ = desk.now + (screen.spoken || screen.one_switch ? kThanksAided : kThanks);
    open_ = false;
    desk.turned = true;
  }
  void lay_out_thanks(Page& page) const {
    if (desk.postcard != 0) lay_out_card(page);
    const TypeScale& t = page.type();
    Column column(page, page.where().words);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 1.5f);
    column.foot_buttons({{"keepsake.done", desk.say("keepsake.leave"), Look::solid}});
    column.foot_space(t.gap);
    column.text(desk.say("keepsake.thanks"), t.title, Face::serif);
    column.space(t.gap);
    column.text(desk.say("keepsake.kept"), t.body);
    column.space(t.gap);
    column.text(name(), t.title, Face::serif);
  }
  void turn_to(bool open) {
    open_ = open;
    gallery_.begin();
    desk.turned = true;
  }

  /// The QR codes, if phones can reach the page. In the museum's network only the page's; with the
  /// kiosk's own access point first the network's, then the page's.
  void lay_out_codes(Column& column) {
    const auto& phone = desk.world.exhibit->phone;
    const std::string network =
        desk.kept_at.empty() ? "" : settings::wifi_code(phone.network, phone.password);
    if (std::exchange(coded_, network + desk.kept_at) != network + desk.kept_at) {
      page_code_ = view::SquareCode(desk.kept_at);
      network_code_ = view::SquareCode(network);
    }
    if (page_code_.empty()) return;
    Page& page = column.page();
    const TypeScale& t = page.type();
    column.space(t.gap);
    if (network_code_.empty()) {
      column.text(desk.say("keepsake.phone"), t.body);
      return put_code(page, page_code_, column.rest());
    }
    // Side by side in reading order, with their words on one line.
    const view::Rect room = column.rest();
    const float half = (room.w - t.gap) / 2;
    float words_high = 0;
    for (const char* step : {"keepsake.join", "keepsake.then"}) {
      const auto size = page.size(desk.say(step), page.style(Face::sans, t.body), half);
      words_high = std::max(words_high, size.height);
      if (size.width > half + 1) page.overflowed();
    }
    const bool from_right = page.right_to_left();
    const view::Rect first{from_right ? room.x + room.w - half : room.x, room.y, half, room.h};
    const view::Rect then{from_right ? room.x : room.x + room.w - half, room.y, half, room.h};
    for (const auto& [at, step, code] :
         {Step{first, "keepsake.join", &network_code_}, Step{then, "keepsake.then", &page_code_}}) {
      const auto style = page.style(Face::sans, t.body);
      page.words({at.x, at.y, at.w, words_high}, desk.say(step), style, view::kInk);
      put_code(page, *code, {at.x, at.y + words_high, at.w, at.h - words_high});
    }
  }

  struct Step {
    Rect at;
    const char* words;
    const view::SquareCode* code;
  };

  /// Placed at the top of `room`, where its words begin. Its quiet zone is space enough.
  static void put_code(Page& page, const view::SquareCode& code, const Rect& room) {
    const float wanted = page.type().body * 7, side = code.width(wanted);
    if (side > room.h || side > room.w) return page.overflowed();
    code.draw(page.items(), page.right_to_left() ? room.x + room.w - side : room.x, room.y, wanted);
  }

  GalleryPage gallery_;
  bool open_ = false;                          ///< The gallery is open.
  bool leaves_ = false;                        ///< The visitor has finished, and is to be thanked.
  std::optional<double> thanks_until_;         ///< The visitor is thanked and may go.
  std::string coded_;                          ///< The texts of the codes.
  view::SquareCode page_code_, network_code_;  ///< Computed once for each page.

  /// A 5:7 card on the plaster, with a soft shadow of several layers and no frame.
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
