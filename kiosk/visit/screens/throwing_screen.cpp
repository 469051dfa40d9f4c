#include "kiosk/visit/screens/throwing_screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "kiosk/visit/screens/fire_button.h"
#include "kiosk/visit/screens/hint.h"
#include "kiosk/visit/screens/instead_of_hands.h"
#include "kiosk/visit/screens/lesson_line.h"
#include "kiosk/visit/screens/measured_pot.h"
#include "kiosk/visit/screens/mishap.h"
#include "kiosk/visit/screens/pot_picture.h"
#include "kiosk/visit/screens/show_me.h"
#include "kiosk/visit/screens/stroke_board.h"
#include "kiosk/visit/screens/target_line.h"
#include "kiosk/visit/screens/telling.h"
#include "kiosk/visit/screens/throwing_controls.h"
#include "kiosk/visit/screens/tool_tray.h"
#include "kiosk/visit/screens/touched_clay.h"
#include "kiosk/visit/screens/water_button.h"
#include "kiosk/visit/screens/wheel_hands.h"
#include "kiosk/visit/screens/wheel_push.h"
#include "kiosk/visit/screens/wheel_speed.h"
#include "kiosk/visit/screens/wire_cut.h"

namespace onggi::screens {

using device::Grip;
using device::WallHold;
using view::InputEvent;
using view::Key;

namespace {

constexpr double kLookIn = 0.8;  // s that the pot stays cut away after a hand was inside
// Opacity of the pot: faint words over black clay keep a contrast of 4.5.
constexpr double kBehindTools = 0.05;
constexpr int kGoodPot = 4;  // stars: from here on nothing need be corrected

class Throwing final : public Screen {
 public:
  explicit Throwing(Desk& d)
      : Screen(d),
        hands_(d.wheel(), d.two_hands() && !StrokeBoard::wanted(d)),
        instead_(d, d.two_hands()),
        speed_(d),
        by_keys_(d.by_keys) {}
  ScreenId id() const override { return ScreenId::throwing; }
  std::string first_focus() const override {
    if (!by_buttons()) return "";
    const bool shows = !desk.touched && aim() != nullptr && !dark() && !hands_.two();
    const bool itself = (instead_.paddle() || (coil().held() && coil().lacks_a_ring())) &&
                        aim() != nullptr && !dark();
    const char* usual = itself   ? "throw.show"
                        : !menu_ ? StrokeBoard::kFirst
                        : shows  ? "throw.show"
                                 : "throw.done";
    return drawer_ != Drawer::closed ? "throw.less" : mishap_ ? "throw.restore" : usual;
  }

  void update(double dt) override {
    if (serial_ != desk.status.scene_serial && desk.pot_ready()) {
      // A new pot needs a standing wheel; a pot that was called done was paused.
      serial_ = desk.status.scene_serial;
      desk.world.wheel_commands->pause(false);
      speed_.send(desk);
      desk.world.wheel_commands->water(water_.wet());
      fire_.gone();
      // A pot that comes back from its result has what its hands held then.
      if (coil().built() || desk.wheel().beating)
        take_up(coil().lacks_a_ring() ? CoilAtWheel::kTool
                : instead_.to_beat()  ? instead_.paddles_place()
                                      : 0);
    }
    if (done_) return finish();
    // The pot is cut off, so the throwing is over.
    if (desk.status.feedback.cut_free >= 1 && !cut_off_) return finish();
    if (cut_off_) draw_wire(dt);
    look_for_mishaps();
    const ShelfCard* card = desk.shelf_card(desk.card);
    const Profile* target = card != nullptr ? &card->target : nullptr;
    inside_until_ = hands_.inside() ? desk.now + kLookIn : inside_until_;
    picture_.update(desk, dt, target, cut_chosen_ ? cut_ : cut_ || desk.now < inside_until_,
                    grabbed());

    std::array<bool, kMaxHands> contacts{};
    for (std::size_t n = 0; n < contacts.size(); ++n)
      contacts[n] = desk.status.feedback.hand[n].contact;
    const bool contact = std::find(contacts.begin(), contacts.end(), true) != contacts.end();
    if (hands_.active() && desk.pot_ready()) {
      show_.draw(dt, hands_.lead(), desk.world.wheel->clay);
      hands_.follow(desk.world.wheel->clay, dt, contacts);
      send_hand();
    }
    if (instead_.active() && desk.pot_ready()) {
      instead_.follow(dt);
      send_hand();
    }
    instead_.aim();
    if (coil().wall_is_there_now() && coil().held()) go_on_from_coil();
    if (const auto speed = push_.speed(dt))
      speed_.push(*speed, desk);
    else
      speed_.run_down(dt, desk);
    strokes_ += std::exchange(worked_, working()) && !working() ? 1 : 0;
    clay_.look(desk, contact);
    // A paddle needs no water.
    water_.look(contact && !instead_.paddle(), desk.status.feedback.wetness, dt);
    fire_.look(desk, dt);
    if (desk.pot_ready() && !mishap_)
      lesson_.update(desk, dt, target, picture_.made(), !show_.showing(), built());
    measured_.update(desk, picture_.made());
    look_how_good(target);
    // Say nothing about the previous pot.
    if (desk.pot_ready())
      hint_.update(desk.now, {target, &picture_.made(), score_ ? &*score_ : nullptr,
                              speed_.asked() > 0, grip_, desk.touched, water_.asked_for(),
                              desk.wheel().tool_radius, built(), coil().held(), instead_.paddle(),
                              ToolTray::way_in(desk, held_), MeasuredPot::hint(desk)});
  }

  std::optional<view::PotView> pot(const Page& page) override {
    if (dark()) return std::nullopt;
    view::PotView pot = picture_.view(desk, page);
    if (desk.pot_ready()) pot.coil = desk.world.wheel->coil;
    pot.embers = fire_.glow();
    if (drawer_ == Drawer::tools) pot.opacity *= kBehindTools;
    wheel_radius_ = pot.wheel_radius;
    return pot;
  }
  bool dark() const override { return desk.eyes_closed(); }
  bool more_fingers() const override { return true; }

  /// A mission explains itself. Do not mention the line if it is hidden, or both hands if each
  /// visitor has one.
  std::vector<std::string> help() const override {
    const settings::Mission* mission = desk.on();
    std::vector<std::string> all;
    if (mission != nullptr && mission->kind != settings::Mission::Kind::today)
      all.push_back(mission->about_in(desk.words().code()));
    if (!desk.two_hands()) {
      const bool built = coil().built();
      if (built) all.push_back(desk.say("help.build"));
      all.push_back(desk.say(built && desk.wheel().beating ? "help.beat" : "help.throw"));
    }
    if (!dark() && desk.described() == nullptr) all.push_back(desk.say("help.throw_line"));
    // A slow wheel is worth a push.
    if (!dark() && coil().built()) all.push_back(desk.say("help.push_wheel"));
    return all;
  }

  std::optional<WheelSnapshot> sight() const override {
    const ShelfCard* card = desk.shelf_card(desk.card);
    if (card == nullptr || !desk.pot_ready() || mishap_) return std::nullopt;
    const std::string& key = hint_.shown().key;
    const std::size_t tool = key == "hint.take_coil"     ? CoilAtWheel::kTool
                             : key == "hint.take_paddle" ? instead_.paddles_place()
                                                         : 0;
    return WheelSnapshot{camera_, &card->target, &picture_.made(), hint_.shown(),
                         tool > 0 ? "throw.tool." + std::to_string(tool) : ""};
  }

  void lay_out(Page& page) override {
    const bool whole = !mishap_;
    const bool onward = desk.touched && whole && drawer_ == Drawer::closed &&
                        LessonLine::leaves_off(desk) && !asks_for_more();
    const ThrowingControls now{
        speed_.asked(),
        grip(),
        water_.wet(),
        cut_,
        fire_there() ? std::optional(fire_.hangs()) : std::nullopt,
        fire_there() ? hint_.shown().key == "hint.wet" : water_.would_help(),
        onward,
        desk.status.can_restore && whole,
        instead_.button(show_.button(desk, aim() == nullptr || dark() || hands_.two())),
        whole && LessonLine::shown(desk) != nullptr,
        drawer_,
        held_,
        coil().held(),
        instead_.paddle(),
        mishap_.now(),
        StrokeBoard::wanted(desk) && whole ? &board_ : nullptr,
        parts(),
        working(),
        by_keys_,
        clay_.asked_for(desk) ? kClayFirst : desk.note()};
    give_the_pot_its_room(page, desk, now);
    camera_ = picture_.camera(page);
    if (const ShelfCard* card = desk.shelf_card(desk.card);
        card != nullptr && desk.pot_ready() && !dark() && drawer_ != Drawer::tools) {
      if (desk.described() == nullptr) draw_ghost(page, camera_, card->target, picture_.made());
      if (const auto& press = hint_.shown().press;
          press && whole &&
          (instead_.paddle() || (!grabbed() && LessonLine::shown(desk) == nullptr)))
        draw_press(page, camera_, card->target, press->height, press->inward);
    }
    lay_out_throwing(page, desk, now, show_, hint_.shown());
  }

  void press(const std::string& control) override {
    if (control == "throw.both") {
      hold_with(Grip::both);
    } else if (control == "throw.outside") {
      hold_with(Grip::outside);
    } else if (control == "throw.inside") {
      hold_with(Grip::inside);
    } else if (control == "throw.water") {
      water_.press(desk.now);
      set_water(water_.wet());
    } else if (control == "throw.fire") {
      fire_.press(desk);
    } else if (control == "throw.cut") {
      cut_ = !cut_;
      cut_chosen_ = true;
    } else if (control == "throw.renew") {
      let_go();
      clay_.renewed(desk);
      desk.world.wheel_commands->renew();
      fire_.hang(false, desk);
      if (coil().built()) take_up(CoilAtWheel::kTool);
    } else if (control == "throw.restore") {
      let_go();
      clay_.undone(desk);
      mishap_.go_back(desk);
    } else if (control == "throw.show" && instead_.held()) {
      work_by_itself();
    } else if (control == "throw.show") {
      if (held_ > 0) take_up(0);
      show_pot();
      if (const Profile* target = aim()) show_.press(desk, *target, key_sign(), hands_.lead());
      send_hand();
    } else if (control == "throw.tools" || control == "throw.wheel" || control == "throw.less") {
      open_drawer(control == "throw.tools"   ? Drawer::tools
                  : control == "throw.wheel" ? Drawer::wheel
                                             : Drawer::closed);
    } else if (control == "throw.skip") {
      LessonLine::skip(desk);
    } else if (control == "throw.done") {
      if (clay_.comes_first(desk)) finish();
    } else if (const auto ask = board_.press(control)) {
      make_stroke(*ask);
    } else if (const auto tool = ToolTray::of_control(control)) {
      take_up(*tool);
    } else if (!speed_.press(control, desk)) {
      desk.force.press(control);
    }
  }

  void hold(const std::string& control) override {
    if (control == "throw.show" && !instead_.held()) {
      if (held_ > 0) take_up(0);
      if (const Profile* target = aim()) show_.hold(desk, *target, key_sign(), hands_.lead());
      send_hand();
    }
    if (control != "throw.water") return;
    water_.hold(desk.now);
    set_water(true);
  }

  void back() override {
    if (drawer_ != Drawer::closed) {
      open_drawer(Drawer::closed);
    } else if (menu_) {
      menu_ = false;
    } else if (active() && !grabbed()) {
      let_go();
    } else {
      desk.go(ScreenId::choose);
    }
  }
  bool leaves_pot(const std::string& control) const override {
    return control == "back" && drawer_ == Drawer::closed && !menu_ && (!active() || grabbed());
  }

  void pointer(const InputEvent& e, const Page& page) override {
    // With two visitors, the one at the buttons stays there.
    if (!hands_.two()) menu_ = by_keys_ = false;
    if (!desk.pot_ready() || desk.world.wheel->clay.rows() == 0 || cut_off_) return;
    const bool down = e.kind == InputEvent::Kind::pointer_down;
    if (down && (e.finger == 0 || hands_.two())) {
      if (page.where().words.contains(e.x, e.y)) return;
      if (drawer_ == Drawer::tools) return open_drawer(Drawer::closed);
      if (!menu_) open_drawer(Drawer::closed);
      mishap_.stay();
      // Hands that still finish a stroke would cross the pot to the next one. With two visitors the
      // other hand continues.
      hands_.two() ? show_.stop(hands_.lead()) : let_go();
    }
    if (show_.showing()) return;
    InputEvent event = e;
    if (!hands_.two()) {
      const WheelPush::Takes takes =
          push_.pointer(e, camera_, wheel_radius_, desk.world.wheel->clay);
      if (takes == WheelPush::Takes::wheel) return;
      if (takes == WheelPush::Takes::lets_go) event.kind = InputEvent::Kind::pointer_down;
    }
    if (instead_.held()) {
      if (instead_.pointer(event, camera_)) send_hand();
      return;
    }
    const Vec2 at = camera_.on_axis_plane(e.x, e.y);
    if (hands_.pointer(event, at, desk.world.wheel->clay, grip(), held_ > 0)) send_hand();
  }

  bool key(Key key, bool repeat) override {
    by_keys_ = true;
    if (KeyedControl pressed = control_of(key); pressed.control != nullptr) {
      if (key == Key::water && fire_there()) pressed.control = "throw.fire";
      const bool there = key != Key::restore || desk.status.can_restore;
      if (there && (!repeat || pressed.repeats)) press(pressed.control);
      return true;
    }
    switch (key) {
      case Key::side:
        if (!repeat) hold_with(device::next_grip(grip_));
        return true;
      case Key::depth_in:
        return move_by_keys(-WheelHands::kNotch, 0), true;
      case Key::depth_out:
        return move_by_keys(WheelHands::kNotch, 0), true;
      default:
        break;
    }
    if (by_buttons()) return false;
    // The hand works on the side away from the words, where the pot is clear. With two visitors the
    // inside hand works on the left.
    const double left = hands_.two() ? -1.0 : key_sign(), notch = WheelHands::kNotch;
    if (key == Key::enter) return menu_ = true;
    if (key == Key::up || key == Key::down)
      return move_by_keys(0, key == Key::up ? notch : -notch), true;
    if (key == Key::left || key == Key::right)
      return move_by_keys(key == Key::left ? -notch * left : notch * left, 0), true;
    return false;
  }

  bool works(const InputEvent&) const override { return true; }
  bool keys_are_anothers() const override { return hands_.two(); }

  void let_go() override {
    show_.stop(hands_.lead());
    hands_.lift();
    instead_.lift();
    push_.lift();
    send_hand();
  }
  void comforted() override { speed_.send(desk); }

  std::optional<PotTold> told() const override {
    if (mishap_) return std::nullopt;
    // With eyes closed, the difference is told after every stroke.
    const int asked = board_.asked() + (dark() ? strokes_ : 0);
    return PotTold{working(), asked,
                   coil().lacks_a_ring() ? std::vector<std::string>{desk.say("hint.lay_ring")}
                                         : StrokeBoard::told(desk, parts())};
  }

 private:
  /// The keys move among buttons and do not move the hand.
  bool by_buttons() const { return menu_ || StrokeBoard::wanted(desk); }
  std::optional<BuiltPot> built() const {
    std::optional<BuiltPot> built = instead_.state();
    if (built) built->wet = FireButton::wet(desk) && !fire_.hangs();
    return built;
  }
  /// Neither coil nor paddle needs water.
  bool fire_there() const { return coil().built() && desk.wheel().moisture && instead_.held(); }
  const CoilAtWheel& coil() const { return instead_.coil(); }
  CoilAtWheel& coil() { return instead_.coil(); }
  bool active() const { return hands_.active() || instead_.active(); }
  bool grabbed() const { return hands_.grabbed() || instead_.grabbed(); }
  bool working() const { return show_.showing() || active() || cut_off_; }
  std::vector<PartOff> parts() const {
    return parts_off(desk.shelf_card(desk.card), picture_.made());
  }
  void make_stroke(device::Ask ask) {
    // No stroke shapes a wall that is not there.
    if (coil().lacks_a_ring()) {
      if (!coil().held()) take_up(CoilAtWheel::kTool);
      if (!coil().by_itself()) work_by_itself();
      return;
    }
    if (held_ > 0) take_up(0);
    const ClayView& clay = desk.world.wheel->clay;
    if (const Profile* target = aim(); target != nullptr && clay.rows() > 0)
      show_.make(asked_stroke(clay, *target, ask, board_.part()), clay, key_sign(), hands_.lead());
    send_hand();
  }
  double key_sign() const { return desk.screen().left_handed ? -1.0 : 1.0; }
  void send_hand() { instead_.held() ? instead_.send(camera_) : hands_.send(desk, camera_); }
  /// Pressed again, it stops.
  void work_by_itself() {
    const bool stop = instead_.by_itself();
    let_go();
    speed_.start(desk);
    if (aim() != nullptr && !stop) {
      instead_.work_by_itself(key_sign());
      if (instead_.paddle() && FireButton::wet(desk)) fire_.hang(true, desk);
    }
    send_hand();
  }
  /// The last ring has closed: the wall is beaten next, if the scene has a paddle. Without one a
  /// new touch builds higher, and buttons go on to the strokes, with the focus where it is.
  void go_on_from_coil() {
    if (instead_.to_beat())
      take_up(instead_.paddles_place());
    else
      by_buttons() ? take_up(0) : let_go();
  }
  /// The target outline, if a hand may work towards it.
  const Profile* aim() const {
    const ShelfCard* card = desk.shelf_card(desk.card);
    return card != nullptr && desk.pot_ready() && !mishap_ && !cut_off_ ? &card->target : nullptr;
  }
  void hold_with(Grip grip) {
    grip_ = grip;
    if (grip == Grip::both || instead_.held()) take_up(0);
    // A hand that works alone inside a closed wall is invisible.
    if (!cut_chosen_) cut_ = grip_ == Grip::inside;
    let_go();
    show_pot();
  }
  /// The tools lie over it: once one is chosen, they go.
  void show_pot() {
    if (drawer_ == Drawer::tools) open_drawer(Drawer::closed);
  }
  /// A tool needs one hand.
  Grip grip() const { return held_ > 0 && grip_ == Grip::both ? Grip::outside : grip_; }
  void take_up(std::size_t which) {
    const SceneForVisitor wheel = desk.wheel();
    if (which > wheel.tools.size() || cut_off_) return;
    const std::string name = which > 0 ? wheel.tools[which - 1].name : "";
    const bool instead = instead_.has(name);
    if (!instead && (name == "coil" || name == scene::kPaddle))
      return;  // two visitors have neither
    let_go();
    show_pot();
    const WallHold::Part fine{0, wheel.tool_radius};
    if (which > 0 && wheel.tools[which - 1].tool == wheel.wire) {
      if (!clay_.comes_first(desk)) return;
      if (instead_.held()) held_ = 0, instead_.take_up("", speed_);
      desk.world.wheel_commands->wheel(0);
      set_water(false);
      cut_off_.emplace(*wheel.wire);
      return;
    }
    held_ = which;
    instead_.take_up(name, speed_);
    // Water's button and charcoal's take each other's place: what has no button is off.
    if (instead) return set_water(false);
    fire_.hang(false, desk);
    if (which == 0) return hands_.take_up({wheel.palm, wheel.palm_radius}, fine);
    const SceneForVisitor::Tool& tool = wheel.tools[which - 1];
    hands_.take_up({tool.tool, tool.reach, tool.below}, fine);
  }
  /// The wheel stops, the wire passes under the pot, and the pot is done.
  void draw_wire(double dt) {
    if (!desk.pot_ready() || std::abs(desk.status.feedback.wheel_speed) > 0.5) return;
    Vec3 right, up, back;
    camera_.basis(right, up, back);
    if (!cut_off_->update(dt, *desk.world.wheel, right, *desk.world.wheel_commands)) return;
    cut_off_.reset();
    finish();
  }
  void set_water(bool on) {
    water_.set(on);
    desk.world.wheel_commands->water(on);
  }

  void move_by_keys(double outward, double up) {
    if (!desk.pot_ready() || desk.world.wheel->clay.rows() == 0 || cut_off_) return;
    menu_ = false;
    open_drawer(Drawer::closed);
    mishap_.stay();
    show_.stop(hands_.lead());
    if (instead_.held())
      instead_.move_by_keys(key_sign(), outward, up);
    else
      hands_.move_by_keys(desk.world.wheel->clay, grip(), key_sign(), outward, up);
    send_hand();
  }

  void finish() {
    const ShelfCard* card = desk.shelf_card(desk.card);
    if (card == nullptr || !desk.pot_ready() || desk.world.wheel->clay.rows() == 0) return;
    let_go();
    set_water(false);
    fire_.hang(false, desk);
    // From here on the pot must not sag, dry or spring back, so that the visitor's result and the
    // keepsake match. It is scored when all its rows have arrived.
    desk.world.wheel_commands->pause(true);
    done_ = !desk.world.wheel_commands->refresh_every_row();
    if (done_) return;
    desk.judge(*card, coil().lacks_a_ring());
    desk.go(ScreenId::result);
  }

  /// The less used controls are in two drawers; a hand on the pot closes them.
  void open_drawer(Drawer which) {
    if (drawer_ != which) desk.turned = true;
    drawer_ = which;
  }

  /// Four times a second, by the measure of the result: what is said now is said there.
  void look_how_good(const Profile* target) {
    if (target == nullptr || target->points.empty() || picture_.made().points.empty() ||
        desk.described() != nullptr || desk.now - judged_ < 0.25)
      return;
    judged_ = desk.now;
    score_ = desk.judged(*desk.shelf_card(desk.card), picture_.made());
    if (!working()) good_ = score_->stars >= kGoodPot;
  }
  /// The words ask for water, or to correct a pot that is not good yet.
  bool asks_for_more() const {
    const Hint& hint = hint_.shown();
    if (LessonLine::shown(desk) != nullptr) return false;  // the wire is what it asks for
    if (hint.key == "hint.dry" || hint.key == "hint.wet") return true;
    if (hint.key == "hint.beaten") return false;
    return desk.described() != nullptr ? hint.key != "mission.close"
                                       : hint.key != "hint.close" && !good_;
  }

  /// After a fall or a tear: releases the pot, and puts the undo where eyes and keys are.
  void look_for_mishaps() {
    if (!mishap_.update(desk)) return;
    desk.turned = true;
    if (!mishap_) return;
    drawer_ = Drawer::closed;
    let_go();
    set_water(false);
  }

  PotPicture picture_;
  TouchedClay clay_;
  HintLine hint_;
  MishapWatch mishap_;
  WheelHands hands_;
  InsteadOfHands instead_;
  std::size_t held_ = 0;  ///< Index in the tray: 0 is the hands.
  std::optional<WireCut> cut_off_;
  ShowMe show_;
  StrokeBoard board_;
  Drawer drawer_ = Drawer::closed;
  WaterButton water_;
  FireButton fire_;
  LessonLine lesson_;
  view::Camera camera_;
  WheelSpeed speed_;
  WheelPush push_;
  double wheel_radius_ = 0;  ///< m, as it is drawn.
  MeasuredPot measured_;
  Grip grip_ = Grip::both;
  bool by_keys_;                       ///< The visitor's last input was a key.
  std::optional<score::Score> score_;  ///< What the pot would get,
  double judged_ = -10;                ///< when it was last looked at.
  bool good_ = false;                  ///< It had kGoodPot stars when last no hand worked.
  bool cut_ = false, cut_chosen_ = false, menu_ = false, done_ = false, worked_ = false;
  int strokes_ = 0;  ///< Finished strokes.
  double inside_until_ = -1;
  std::uint32_t serial_ = 0;
};

}  // namespace

std::unique_ptr<Screen> make_throwing(Desk& desk) { return std::make_unique<Throwing>(desk); }

}  // namespace onggi::screens
