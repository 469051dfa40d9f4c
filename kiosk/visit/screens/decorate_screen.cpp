#include "kiosk/visit/screens/decorate_screen.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "kiosk/visit/screens/decorate_controls.h"
#include "kiosk/visit/screens/overlays.h"
#include "kiosk/visit/screens/pot_picture.h"
#include "kiosk/visit/screens/stroke_board.h"
#include "kiosk/visit/screens/turntable.h"

namespace onggi::screens {

using decorating::DecoratedPot;
using decorating::Place;
using decoration::WayTool;

namespace {

constexpr double kRoundTurn = 2.0 * 3.14159265358979;
constexpr double kRingTime = 2.4;    // s for the turn under a resting finger
constexpr double kGoodWhile = 90.0;  // s, the soft end
constexpr double kRead = 15.0;       // s for a tool's words, since it was chosen or used
constexpr double kMarkStep = 0.004;  // m for an arrow key,
constexpr double kButtonStep = 0.1;  // and the share of the outline for a button
constexpr int kMarkPoints = 48;

/// The pot is decorated with the tools of its vessel's makers. A finger on the pot leads the tool,
/// one beside it turns the pot.
class Decorate final : public Screen {
 public:
  explicit Decorate(Desk& d) : Screen(d), pot_(desk.pot_to_decorate()), since_(desk.now) {
    if (pot_ != nullptr) mark_ = 0.6 * outside();
  }
  ScreenId id() const override { return ScreenId::decorate; }
  std::string first_focus() const override { return "decorate.tool.0"; }

  void update(double dt) override {
    picture_.update(desk, dt, nullptr, false, true);
    picture_.show_round(desk, dt, 0.0);
    if (pot_ == nullptr) return desk.go(next_screen());
    // The pot turns under a resting finger, and on while the ring that it began is closed.
    const bool turns = pot_->turns() || (pot_->busy() && pot_->held().hand == WayTool::ring);
    if (turns && !desk.still())
      turned_ += (desk.screen().left_handed ? -dt : dt) * kRoundTurn / kRingTime;
    if (finger_ && turns) follow();
    pot_->update(dt);
  }

  std::optional<view::PotView> pot(const Page& page) override {
    view::PotView pot = picture_.view(desk, page);
    pot.hands = {};
    pot.wetness = 0;
    pot.wetness_by_row.clear();
    const double turned = turned_ + table_.angle();
    pot.clay_angle += turned;
    pot.wheel_angle += turned;
    camera_ = pot.camera;
    angle_ = pot.clay_angle;
    return pot;
  }

  void lay_out(Page& page) override {
    if (pot_ == nullptr) return;
    const std::string arrows = desk.screen().one_switch ? "" : desk.say("help.decorate_keys");
    page.control({kMark, page.where().pot, desk.say("decorate.here"), {}, arrows, true});
    const bool keyed = page.focused(kMark);
    table_.keyed(keyed);
    // The tool's own words come first.
    lay_out_decorating(page, desk, *pot_,
                       !pot_->bare() && desk.now > std::max(since_ + kGoodWhile, used_ + kRead));
    camera_ = picture_.camera(page);
    const bool marks = marks_ || StrokeBoard::wanted(desk);
    if (keyed || marks) draw_mark(page);
    if (marks)
      page.tell(
          page.where().pot.y,
          desk.say("decorate.at", {{"mm", std::to_string(std::lround(1000 * mark_row().height))}}));
  }

  void press(const std::string& control) override {
    if (pot_ == nullptr) return;
    if (control == "decorate.on") return go_on();
    if (control == kMark || control == "decorate.here") return pot_->put({mark_, front()});
    if (control == "decorate.higher" || control == "decorate.lower") {
      marks_ = true;
      return move_mark((control == "decorate.higher" ? kButtonStep : -kButtonStep) * outside());
    }
    if (control == "decorate.turn_left" || control == "decorate.turn_right")
      return table_.press(control == "decorate.turn_right" ? -1.0 : 1.0, desk.now);
    if (press_decorating(control, *pot_)) used_ = desk.now;
  }
  void back() override { desk.go(ScreenId::result); }

  void pointer(const view::InputEvent& e, const Page& page) override {
    using Kind = view::InputEvent::Kind;
    if (pot_ == nullptr) return;
    if (e.kind == Kind::pointer_down && !finger_ && !turning_) {
      finger_ = {e.x, e.y};
      const auto at = touched();
      used_ = desk.now;
      if (at && !pot_->busy()) return pot_->press(*at);
      finger_.reset();
      turning_ = !at;
    }
    if (turning_) {
      table_.pointer(e, 0.5f * page.where().pot.w);
      turning_ = e.kind != Kind::pointer_up;
      return;
    }
    if (!finger_) return;
    finger_ = {e.x, e.y};
    if (e.kind == Kind::pointer_up) return let_go();
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
    pot_->undo();
    return true;
  }
  void let_go() override {
    finger_.reset();
    if (pot_ != nullptr) pot_->lift();
  }

 private:
  ScreenId next_screen() const { return desk.wheel().kiln ? ScreenId::kiln : ScreenId::keepsake; }
  void go_on() {
    pot_->finish();
    if (!desk.wheel().kiln) desk.keep_pot();
    desk.go(next_screen());
  }

  std::optional<Place> touched() const {
    if (!camera_ || !finger_) return std::nullopt;
    return decorating::place_under(*camera_, pot_->surface(), angle_, finger_->first,
                                   finger_->second);
  }
  void follow() {
    if (const auto at = touched()) pot_->move(*at);
  }

  /// The outside's length, m.
  double outside() const { return pot_->outside(); }
  void move_mark(double by) { mark_ = std::clamp(mark_ + by, 0.004, outside() - 0.002); }
  /// Where the pot faces the eye, round it.
  double front() const {
    const double turns =
        (0.25 * kRoundTurn - (camera_ ? camera_->azimuth : 0.0) - angle_) / kRoundTurn;
    return turns - std::floor(turns);
  }

  const surface::Row& mark_row() const {
    return pot_->surface().row(std::clamp(static_cast<int>(mark_ * 1e6) / surface::kRowHeight, 0,
                                          pot_->surface().rows() - 1));
  }
  /// The mark's height as a line round the part of the pot that faces the eye.
  void draw_mark(Page& page) const {
    const surface::Row& row = mark_row();
    view::Line line;
    for (int n = 0; n <= kMarkPoints; ++n) {
      const double angle = kRoundTurn * 0.5 * n / kMarkPoints - camera_->azimuth;
      const auto at = camera_->project(
          {row.radius * std::cos(angle), row.height, row.radius * std::sin(angle)});
      if (at) line.points.push_back(*at);
    }
    line.colors = {view::kCobalt};
    line.width = page.type().body / 9.0f;
    page.draw(std::move(line));
  }

  DecoratedPot* pot_;  ///< Null: the vessel has no way, or the pot no outline.
  PotPicture picture_;
  Turntable table_;
  double since_, used_ = 0;
  double turned_ = 0, angle_ = 0, mark_ = 0;
  bool marks_ = false, turning_ = false;
  std::optional<std::pair<float, float>> finger_;  ///< That leads the tool, pixels.
  std::optional<view::Camera> camera_;             ///< Of the last frame.
};

}  // namespace

std::unique_ptr<Screen> make_decorate(Desk& desk) { return std::make_unique<Decorate>(desk); }

}  // namespace onggi::screens
