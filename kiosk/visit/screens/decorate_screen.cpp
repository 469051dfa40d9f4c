#include "kiosk/visit/screens/decorate_screen.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/visit/decorating/example.h"
#include "kiosk/visit/decorating/touch_queue.h"
#include "kiosk/visit/screens/decorate_controls.h"
#include "kiosk/visit/screens/decorate_drawing.h"
#include "kiosk/visit/screens/led_tool.h"
#include "kiosk/visit/screens/overlays.h"
#include "kiosk/visit/screens/pot_picture.h"
#include "kiosk/visit/screens/stroke_board.h"
#include "kiosk/visit/screens/turntable.h"

namespace onggi::screens {

using decorating::DecoratedPot;
using decorating::Example;
using decorating::Place;
using decorating::TouchQueue;
using decoration::WayTool;

namespace {

constexpr double kRoundTurn = 2.0 * 3.14159265358979;
constexpr double kRingTime = 2.4;    // s for the turn under a resting finger
constexpr double kGoodWhile = 90.0;  // s, the soft end
constexpr double kRead = 15.0;       // s for a tool's words, since it was chosen or used
constexpr const char* kStateNames[] = {"soft", "leather", "dry", "fired", "glazed"};
constexpr double kMarkStep = 0.004;  // m for an arrow key,
constexpr double kButtonStep = 0.1;  // and the share of the outline for a button
constexpr double kJoined = 0.4;      // s: a finger that a second one joins so soon drew nothing
constexpr double kWord = 3.0;        // s that a state's word is shown,
constexpr double kWordFades = 0.3;   // and comes and goes

/// The pot is decorated with the tools of its vessel's makers. A finger on the pot leads the tool,
/// one beside it turns the pot, and two turn and tilt it.
class Decorate final : public Screen {
 public:
  explicit Decorate(Desk& d) : Screen(d), pot_(desk.pot_to_decorate()), since_(desk.now) {
    if (pot_ == nullptr) return;
    mark_ = 0.6 * outside();
    touches_.emplace(*pot_);
    if (desk.world.wheel_commands != nullptr) led_.emplace(*desk.world.wheel_commands);
    state_ = pot_->state();
  }
  ScreenId id() const override { return ScreenId::decorate; }
  std::string first_focus() const override { return "decorate.tool.0"; }

  void update(double dt) override {
    picture_.update(desk, dt, nullptr, false, true);
    picture_.show_round(desk, dt, 0.0);
    if (pot_ == nullptr) return desk.go(next_screen());
    // The pot turns under a resting finger, and on while the ring that it began is closed.
    const bool closes = pot_->busy() && pot_->held().hand == WayTool::ring && !touches_->waits();
    const bool turns = pot_->turns() || closes;
    turned_by_ = 0.0;
    if (turns && !desk.still())
      turned_by_ = (desk.screen().left_handed ? -dt : dt) * kRoundTurn / kRingTime;
    turned_ += turned_by_;
    if (finger_ && turns) follow_round();
    if (led_) {
      const bool free = !finger_ && !turning_;
      const bool touched = led_->update(desk.status, *pot_, angle_, dt, free, *touches_);
      if (touched || led_->touches()) used_ = desk.now;
    }
    example_.step(dt, seen().front(), *pot_);
    touches_->update(dt, example_.hurries());
    look_at_state();
  }

  std::optional<view::PotView> pot(const Page& page) override {
    view::PotView pot = picture_.view(desk, page);
    pot.hands = {};
    pot.wetness = 0;
    pot.slip_wet = true;
    pot.wetness_by_row = pot_ != nullptr ? pot_->wetness() : std::vector<float>{};
    const double turned = turned_ + table_.angle();
    pot.clay_angle += turned;
    pot.wheel_angle += turned;
    pot.camera.elevation += table_.tilt();
    camera_ = pot.camera;
    angle_ = pot.clay_angle;
    return pot;
  }

  void lay_out(Page& page) override {
    if (pot_ == nullptr) return;
    const std::string arrows = desk.screen().one_switch ? "" : desk.say("help.decorate_keys");
    camera_ = picture_.camera(page);
    camera_->elevation += table_.tilt();
    view::Rect on_pot = seen_box(seen());
    const float words = word_top(page, seen(), desk.say("decorate.starts"), page.type().lead);
    on_pot.h = std::min(on_pot.h, words - on_pot.y);
    page.control({kMark, touchable(on_pot, page), desk.say("decorate.here"), {}, arrows, true});
    const bool keyed = page.focused(kMark);
    table_.keyed(keyed);
    // The tool's own words come first.
    lay_out_decorating(
        page, desk, *pot_, example_.shows(),
        !pot_->bare() && !desk.curated && desk.now > std::max(since_ + kGoodWhile, used_ + kRead));
    bool begins = false;
    if (const ShelfCard* card = desk.shelf_card(desk.card);
        card != nullptr && card->vessel != nullptr && !example_.shows() &&
        !pot_->waits(pot_->tool()))
      begins = draw_starts(page, seen(), card->vessel->starts);
    if (led_ && led_->finger()) draw_finger(page, seen(), *led_->finger());
    if (example_.finger()) draw_finger(page, seen(), *example_.finger());
    const bool marks = marks_ || StrokeBoard::wanted(desk);
    if (keyed || marks) draw_mark(page, seen(), mark_);
    if (marks)
      page.tell(
          page.where().pot.y,
          desk.say("decorate.at", {{"mm", std::to_string(std::lround(1000 * mark_row().height))}}));
    if (!tell_state(page) && begins && pot_->bare())
      draw_word(page, seen(), desk.say("decorate.starts"), page.type().body, 1.0f);
  }

  void press(const std::string& control) override {
    if (pot_ == nullptr) return;
    const bool showed = example_.shows();
    example_.stop(*pot_);
    if (control == "decorate.show") {
      touches_->settle();
      if (!showed) example_.begin(*pot_);
      used_ = desk.now;
      return;
    }
    if (control == "decorate.on") return go_on();
    if (control == kMark || control == "decorate.here")
      return touches_->put({mark_, seen().front()});
    if (control == "decorate.higher" || control == "decorate.lower") {
      marks_ = true;
      return move_mark((control == "decorate.higher" ? kButtonStep : -kButtonStep) * outside());
    }
    if (control == "decorate.turn_left" || control == "decorate.turn_right")
      return table_.press(control == "decorate.turn_right" ? -1.0 : 1.0, desk.now);
    touches_->settle();
    if (press_decorating(control, *pot_)) used_ = desk.now;
  }
  void back() override { desk.go(ScreenId::result); }

  bool more_fingers() const override { return true; }
  /// A finger that rests on the pot draws a ring, and a held arrow moves the mark: neither asks to
  /// be read to.
  bool works(const view::InputEvent& e) const override {
    using Kind = view::InputEvent::Kind;
    if (e.kind == Kind::key_down || e.kind == Kind::key_up)
      return e.key == view::Key::up || e.key == view::Key::down || e.key == view::Key::left ||
             e.key == view::Key::right;
    return pot_ != nullptr && camera_ &&
           decorating::place_under(*camera_, pot_->surface(), angle_, e.x, e.y).has_value();
  }
  void pointer(const view::InputEvent& e, const Page& page) override {
    using Kind = view::InputEvent::Kind;
    if (pot_ == nullptr) return;
    const float half_turn = 0.5f * page.where().pot.w;
    if (table_.pair(e, half_turn)) return end_stroke();
    if (e.finger != 0) return;
    if (e.kind == Kind::pointer_down && !finger_ && !turning_) {
      finger_ = {e.x, e.y};
      const auto at = touched();
      used_ = pressed_at_ = desk.now;
      // A touch takes the tool over from an example.
      if (at) {
        example_.stop(*pot_);
        return touches_->press(*at);
      }
      finger_.reset();
      turning_ = true;
    }
    if (turning_) {
      table_.pointer(e, half_turn);
      turning_ = e.kind != Kind::pointer_up;
      return;
    }
    if (!finger_) return;
    finger_ = {e.x, e.y};
    if (e.kind == Kind::pointer_move && pot_->turns()) return been_.push_back(*finger_);
    if (e.kind == Kind::pointer_up) return let_go_of_pot();
    follow();
  }

  std::string step(const std::string& from, Direction to) override {
    if (from != kMark || pot_ == nullptr) return {};
    if (to == Direction::left || to == Direction::right) table_.by_arrow(to == Direction::right);
    if (to == Direction::up) move_mark(kMarkStep);
    if (to == Direction::down) move_mark(-kMarkStep);
    return from;
  }
  bool key(view::Key key, bool /*repeat*/) override {
    if (key != view::Key::restore || pot_ == nullptr) return false;
    press("decorate.undo");
    return true;
  }
  void let_go() override {
    table_.let_go();
    turning_ = false;
    if (pot_ == nullptr) return;
    example_.stop(*pot_);
    if (led_) led_->let_go(*touches_);
    let_go_of_pot();
  }

 private:
  ScreenId next_screen() const { return desk.wheel().kiln ? ScreenId::kiln : ScreenId::keepsake; }
  void go_on() {
    touches_->settle();
    pot_->finish();
    if (!desk.wheel().kiln && !desk.curated) desk.keep_pot();
    desk.go(next_screen());
  }

  std::optional<Place> touched(double turned_on = 0.0) const {
    if (!camera_ || !finger_) return std::nullopt;
    return decorating::place_under(*camera_, pot_->surface(), angle_ + turned_on, finger_->first,
                                   finger_->second);
  }
  void follow() {
    if (const auto at = touched()) touches_->move(*at);
  }
  /// The pot turned while the finger went from place to place. A frame may be slow: with one angle
  /// for all places a ring would be a staircase. They are taken as evenly apart in time.
  void follow_round() {
    if (been_.empty()) been_.push_back(*finger_);
    for (std::size_t n = 0; n < been_.size(); ++n) {
      finger_ = been_[n];
      const double passed = static_cast<double>(n + 1) / static_cast<double>(been_.size());
      if (const auto at = touched(passed * turned_by_)) touches_->move(*at);
    }
    been_.clear();
  }
  void let_go_of_pot() {
    if (finger_ && !been_.empty()) follow_round();
    if (finger_) touches_->lift();
    finger_.reset();
  }
  /// A second finger has come: the first has drawn enough, or has only just touched.
  void end_stroke() {
    turning_ = false;
    if (finger_ && desk.now - pressed_at_ < kJoined) {
      touches_->cancel();
      been_.clear();
      finger_.reset();
    }
    let_go_of_pot();
  }

  /// The clay has come further: a word says so.
  void look_at_state() {
    const WayTool::State now = pot_->state();
    if (now > state_) told_at_ = desk.now;
    state_ = now;
  }
  bool tell_state(Page& page) const {
    const double since = desk.now - told_at_;
    if (since > kWord || state_ == WayTool::soft) return false;
    const std::string word = desk.say(std::string("decorate.state_") + kStateNames[state_]);
    const double shown = std::min(since, kWord - since) / kWordFades;
    draw_word(page, seen(), word, page.type().lead,
              desk.still() ? 1.0f : static_cast<float>(std::clamp(shown, 0.0, 1.0)));
    return true;
  }

  /// No smaller than a finger needs, and on the page.
  static view::Rect touchable(view::Rect pot, const Page& page) {
    const float w = std::max(pot.w, page.type().target), h = std::max(pot.h, page.type().target);
    const view::Rect& all = page.where().all;
    return {std::clamp(pot.x - (w - pot.w) / 2, all.x, all.x + all.w - w),
            std::clamp(pot.y - (h - pot.h) / 2, all.y, all.y + all.h - h), w, h};
  }
  /// The outside's length, m.
  double outside() const { return pot_->outside(); }
  void move_mark(double by) { mark_ = std::clamp(mark_ + by, 0.004, outside() - 0.002); }
  SeenPot seen() const { return {*pot_, camera_.value_or(view::Camera{}), angle_}; }

  const surface::Row& mark_row() const {
    return pot_->surface().row(std::clamp(static_cast<int>(mark_ * 1e6) / surface::kRowHeight, 0,
                                          pot_->surface().rows() - 1));
  }
  DecoratedPot* pot_;                  ///< Null: the vessel has no way, or the pot no outline.
  std::optional<TouchQueue> touches_;  ///< As long as pot_.
  std::optional<LedTool> led_;         ///< A hand device, if the wheel has any.
  Example example_;
  PotPicture picture_;
  Turntable table_;
  double since_, used_ = 0, pressed_at_ = 0;
  WayTool::State state_ = WayTool::soft;
  double told_at_ = -10;
  double turned_ = 0, turned_by_ = 0;  ///< By rings, and in the last frame, rad.
  double angle_ = 0, mark_ = 0;
  bool marks_ = false, turning_ = false;
  std::optional<std::pair<float, float>> finger_;  ///< That leads the tool, pixels.
  std::vector<std::pair<float, float>> been_;      ///< Where it has been since the last frame.
  std::optional<view::Camera> camera_;             ///< Of the last frame.
};

}  // namespace

std::unique_ptr<Screen> make_decorate(Desk& desk) { return std::make_unique<Decorate>(desk); }

}  // namespace onggi::screens
