#include "kiosk/visit/screens/clay_screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "kiosk/visit/screens/overlays.h"
#include "kiosk/visit/screens/pot_picture.h"
#include "kiosk/visit/screens/show_me.h"
#include "kiosk/visit/screens/stroke_board.h"
#include "kiosk/visit/screens/wheel_hands.h"
#include "kiosk/visit/screens/wheel_speed.h"

namespace onggi::screens {

using device::Grip;
using view::Face;
using view::InputEvent;
using view::Key;

namespace {

// Of the outer radius, in one touch: who presses the pot's middle would cut it in two.
constexpr double kDeepest = 0.3;

class FirstClay final : public Screen {
 public:
  explicit FirstClay(Desk& d)
      : Screen(d),
        half_built_(d.attract_builds && !d.status.script_done),
        picture_(d.attract_picture ? d.attract_picture : std::make_shared<PotPicture>()),
        hands_(scene_of(d, half_built_), false),
        speed_(d),
        began_(std::exchange(d.began_on_clay, std::nullopt)) {
    desk.world.wheel_commands->play(nullptr);
    // Nobody can shape a pot that was cut off, has fallen, or is half built.
    const auto& felt = desk.status.feedback;
    if (felt.cut_free > 0 || felt.fallen || felt.torn || half_built_)
      desk.start_pot(desk.attract_card, true, "");
    if (desk.pot_ready()) take_over();
  }
  ScreenId id() const override { return ScreenId::clay; }
  std::string first_focus() const override {
    return by_buttons() ? "clay.press" : menu_ ? "clay.on" : "";
  }

  void update(double dt) override {
    if (desk.pot_ready() && serial_ != desk.status.scene_serial) take_over();
    picture_->update(desk, dt, target(), false, hands_.grabbed());
    if (!hands_.active() || !desk.pot_ready()) return;
    std::array<bool, kMaxHands> contacts{};
    for (std::size_t n = 0; n < contacts.size(); ++n)
      contacts[n] = desk.status.feedback.hand[n].contact;
    show_.draw(dt, hands_.lead(), desk.world.wheel->clay);
    hands_.follow(desk.world.wheel->clay, dt, contacts);
    send_hand();
  }

  std::optional<view::PotView> pot(const Page& page) override { return picture_->view(desk, page); }

  void lay_out(Page& page) override {
    camera_ = picture_->camera(page);
    const TypeScale& t = page.type();
    Column column(page, page.where().words);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 2);
    std::vector<Button> ways{{"clay.on", desk.say("choose.title"), Look::solid}};
    if (by_buttons())
      ways.insert(ways.begin(), Button{"clay.press", desk.say("clay.press"), Look::outline});
    column.foot_buttons(ways);
    column.foot_space(t.gap * 2);
    column.text(desk.say("clay.title"), t.display, Face::serif);
    column.space(t.gap);
    column.text(desk.say(by_buttons() ? "clay.by_button"
                         : keyed_     ? "clay.by_keys"
                                      : "clay.lead"),
                t.body);
  }

  void press(const std::string& control) override {
    if (control == "clay.on") desk.go(ScreenId::choose);
    if (control != "clay.press" || target() == nullptr) return;
    const ClayView& clay = desk.world.wheel->clay;
    if (!desk.pot_ready() || clay.rows() == 0) return;
    show_.make(asked_stroke(clay, *target(), device::Ask::narrow, device::WallPart::middle), clay,
               side(), hands_.lead());
    send_hand();
  }
  void back() override {
    if (menu_ && !by_buttons())
      menu_ = false;
    else
      desk.go(ScreenId::attract);
  }

  bool works(const InputEvent& e) const override {
    const bool key = e.kind == InputEvent::Kind::key_down || e.kind == InputEvent::Kind::key_up;
    return key ? arrow(e.key) : picture_->on_clay(camera_.on_axis_plane(e.x, e.y));
  }
  void pointer(const InputEvent& e, const Page& page) override {
    menu_ = keyed_ = false;
    if (began_ && e.kind == InputEvent::Kind::pointer_up) began_.reset();
    if (!desk.pot_ready() || desk.world.wheel->clay.rows() == 0) return;
    if (e.kind == InputEvent::Kind::pointer_down) {
      if (page.where().words.contains(e.x, e.y)) return;
      let_go();
    }
    grab(e, camera_.on_axis_plane(e.x, e.y));
  }
  bool key(Key key, bool) override {
    if (by_buttons()) return false;
    if (key == Key::next) menu_ = true;
    if (menu_) return false;
    if (key == Key::enter) return desk.go(ScreenId::choose), true;
    if (!arrow(key) || !desk.pot_ready() || desk.world.wheel->clay.rows() == 0) return false;
    keyed_ = true;
    const double notch = WheelHands::kNotch;
    const double up = key == Key::up ? notch : key == Key::down ? -notch : 0;
    const double right = key == Key::right ? notch : key == Key::left ? -notch : 0;
    hands_.move_by_keys(desk.world.wheel->clay, Grip::both, side(), right * side(), up);
    send_hand();
    return true;
  }

  void let_go() override {
    began_.reset();
    show_.stop(hands_.lead());
    hands_.lift();
    send_hand();
    desk.world.wheel_commands->water(false);
  }
  void comforted() override { speed_.send(desk); }

 private:
  /// Of the pot that a finger shapes here: one that was half built gives way to a lump to throw.
  static const SceneForVisitor& scene_of(Desk& desk, bool half_built) {
    if (half_built) desk.attract_builds = false;
    return desk.wheel();
  }
  static bool arrow(Key key) {
    return key == Key::up || key == Key::down || key == Key::left || key == Key::right;
  }
  bool by_buttons() const { return StrokeBoard::wanted(desk); }
  double side() const { return desk.screen().left_handed ? -1.0 : 1.0; }
  const Profile* target() const {
    const ShelfCard* card = desk.shelf_card(desk.attract_card);
    return card != nullptr ? &card->target : nullptr;
  }
  /// The pot is the visitor's: it turns, and gives way under the finger that is there.
  void take_over() {
    serial_ = desk.status.scene_serial;
    speed_.send(desk);
    for (int n = 0; n < kMaxHands; ++n) desk.world.wheel_commands->hand(n, HandInput{});
    const auto began = std::exchange(began_, std::nullopt);
    if (!began || by_buttons()) return;
    camera_ = began->camera;
    const InputEvent& e = began->event;
    if (e.kind == InputEvent::Kind::key_down)
      key(e.key, false);
    else
      grab(e, camera_.on_axis_plane(e.x, e.y));
  }
  void grab(const InputEvent& e, Vec2 at) {
    if (e.kind == InputEvent::Kind::pointer_down) touched_ = desk.world.wheel->clay.profile();
    if (!touched_.points.empty())
      at.x =
          std::copysign(std::max(std::abs(at.x), (1 - kDeepest) * touched_.outer_at(at.y)), at.x);
    if (!hands_.pointer(e, at, desk.world.wheel->clay, Grip::both, false)) return;
    desk.world.wheel_commands->water(hands_.grabbed());  // wet clay gives way
    send_hand();
  }
  void send_hand() { hands_.send(desk, camera_); }

  const bool half_built_;  ///< Attract was building it of coils.
  std::shared_ptr<PotPicture> picture_;
  WheelHands hands_;
  WheelSpeed speed_;
  ShowMe show_;
  view::Camera camera_;
  std::optional<Desk::Began> began_;  ///< Waits for its pot.
  Profile touched_;                   ///< The pot as it was when the finger went down.
  bool menu_ = false;                 ///< The keys move among buttons.
  bool keyed_ = false;                ///< The arrows pressed last.
  std::uint32_t serial_ = 0;
};

}  // namespace

std::unique_ptr<Screen> make_clay(Desk& desk) { return std::make_unique<FirstClay>(desk); }

}  // namespace onggi::screens
