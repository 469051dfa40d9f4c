#include "kiosk/visit/screens/kiln_screen.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "kiosk/visit/decorating/touched_place.h"
#include "kiosk/visit/screens/decorate_controls.h"
#include "kiosk/visit/screens/decorate_drawing.h"
#include "kiosk/visit/screens/hidden_drawing.h"
#include "kiosk/visit/screens/label.h"
#include "kiosk/visit/screens/light_color.h"
#include "kiosk/visit/screens/moved_light.h"
#include "kiosk/visit/screens/overlays.h"
#include "kiosk/visit/screens/pot_picture.h"
#include "kiosk/visit/screens/target_line.h"
#include "kiosk/visit/screens/wall_section.h"

namespace onggi::screens {

using view::Face;

namespace {

constexpr double kGlazeShowSpeed = 1.2;  // rad/s: the visitor sees the glaze from all sides
constexpr double kDryTime = 4.0;         // s; for an impatient visitor a fifth of it
constexpr double kFireTime = 6.0;        // s
constexpr double kReglazeTime = 2.4;     // s
constexpr double kTextFade = 0.5;        // s
constexpr const char *kLight = "kiln.light", *kSection = "kiln.section";
constexpr double kFirstPlace = 0.55;  // of the outside's length, until a finger says where
constexpr float kTap = 0.5f;          // of a touch target: a finger that moves less is a tap
// Times in the firing: the heat is highest here, and the glaze appears as it falls.
constexpr float kGlassy = 0.3f;  // gloss: a glaze with less is none that melts
constexpr double kHottest = 0.4, kGlazeFrom = 0.3, kGlazeTo = 0.95;

double smooth(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}
double along(double from, double to, double share) { return from + (to - from) * share; }

/// The pot dries, gets the glaze that the visitor chooses, and comes out smaller. Another choice
/// glazes it again. The visitor never has to wait.
class KilnScreen final : public Screen {
 public:
  explicit KilnScreen(Desk& d) : Screen(d), kiln_(*desk.wheel().kiln), shown_(desk.glaze) {
    if (desk.decorated && !desk.decorated->plain()) hides_ = hiding(*desk.decorated, kiln_);
    if (desk.glaze >= 0) finish();
  }
  ScreenId id() const override { return ScreenId::kiln; }
  std::string first_focus() const override {
    if (desk.glaze >= 0) return "kiln.keep";
    const bool first = is_offered(0);
    const auto other = std::ranges::find_if(kiln_.order, [this](int i) { return is_offered(i); });
    return glaze_control(first ? 0 : *other);
  }

  void update(double dt) override {
    picture_.update(desk, dt, nullptr, false, false);
    burn_slips(dt);
    // It stands still while its wall is looked at.
    const double speed = place_ ? 0.0 : kGlazeShowSpeed;
    picture_.show_round(desk, dt, desk.screen().left_handed ? -speed : speed);
    if (desk.still()) return finish();
    const bool chosen = desk.glaze >= 0;
    dried_ = std::min(1.0, dried_ + dt / (chosen ? 0.2 * kDryTime : kDryTime));
    if (dried_ < 1 || !chosen) return;
    if (shown_ < 0) shown_ = desk.glaze;
    const bool was_fired = fired_ >= 1;
    fired_ = std::min(1.0, fired_ + dt / kFireTime);
    if (fired_ >= 1 && !was_fired) told_at_ = desk.now;
    if (fired_ < 1) return;
    if (reglazed_ >= 1 && shown_ != desk.glaze) {
      before_ = shown_;
      shown_ = desk.glaze;
      reglazed_ = 0;
    }
    reglazed_ = std::min(1.0, reglazed_ + dt / kReglazeTime);
  }

  std::optional<view::PotView> pot(const Page& page) override {
    view::PotView pot = picture_.view(desk, page);
    pot.wheel = false;
    pot.hands = {};
    window_ = pot.window;
    const double across = page.where().portrait ? MovedLight::kFarthest : MovedLight::kNearWords;
    if (window_ < 0)
      light_.keep_within(-MovedLight::kFarthest, across);
    else
      light_.keep_within(-across, MovedLight::kFarthest);
    pot.window = light_.at(window_);
    pot.size = along(along(1, kiln_.dried_size, smooth(dried_)), kiln_.fired_size, smooth(fired_));
    pot.wetness *= 1 - dried_;
    for (float& wet : pot.wetness_by_row) wet *= static_cast<float>(1 - dried_);
    seen_ = pot.camera;
    seen_.target = 1 / pot.size * seen_.target;
    seen_.distance /= pot.size;
    angle_ = pot.clay_angle;
    if (shown_ < 0) return pot;
    pot.glazing = glazing(shown_);
    if (fired_ < 1) {
      pot.finish = view::Finish::firing;
      const double heat = fired_ < kHottest ? fired_ / kHottest : (1 - fired_) / (1 - kHottest);
      pot.firing = {std::nullopt, smooth((fired_ - kGlazeFrom) / (kGlazeTo - kGlazeFrom)),
                    smooth(heat)};
    } else if (reglazed_ < 1) {
      pot.finish = view::Finish::firing;
      pot.firing = {glazing(before_), smooth(reglazed_),
                    0.5 * smooth(1 - std::abs(2 * reglazed_ - 1))};
    } else {
      pot.finish = view::Finish::fired;
    }
    return pot;
  }

  void lay_out(Page& page) override {
    lay_out_words(page);
    lay_out_light(page);
    if (place_) draw_place(page, {*desk.decorated, seen_, angle_}, *place_);
  }

  void press(const std::string& control) override {
    if (control == kLight) return fired() ? light_.press(window_) : finish();
    if (control == kSection && has_section()) {
      if (std::exchange(place_, std::nullopt)) return;
      const SeenPot pot{*desk.decorated, seen_, angle_};
      place_ = decorating::Place{kFirstPlace * desk.decorated->outside(), pot.front()};
      return;
    }
    if (control == "kiln.keep") {
      finish();
      burn_slips(0);
      desk.keep_pot();
      desk.go(ScreenId::keepsake);
      return;
    }
    for (int i = 0; i < static_cast<int>(kiln_.glazes->size()); ++i) {
      if (control != glaze_control(i) || desk.glaze == i) continue;
      desk.glaze = i;
      chosen_at_ = desk.now;
    }
  }
  void back() override {
    desk.go(desk.wheel().way != nullptr && desk.glaze < 0 ? ScreenId::decorate : ScreenId::result);
  }

  /// A touch on the pot skips ahead, and a finger draws the light along.
  void pointer(const view::InputEvent& e, const Page& page) override {
    if (desk.glaze < 0) return;
    if (e.kind == view::InputEvent::Kind::pointer_down) {
      tapped_ = has_section();
      tapped_at_ = {e.x, e.y};
      finish();
    }
    tapped_ = tapped_ && std::hypot(e.x - tapped_at_.first, e.y - tapped_at_.second) <
                             kTap * page.type().target;
    if (tapped_ && e.kind == view::InputEvent::Kind::pointer_up) {
      if (const auto at =
              decorating::place_under(seen_, desk.decorated->surface(), angle_, e.x, e.y))
        place_ = at;
    }
    light_.pointer(e, window_, page.where().pot.w);
  }
  std::string step(const std::string& from, Direction to) override {
    if (from != kLight || (to != Direction::left && to != Direction::right)) return {};
    if (fired()) light_.by_arrow(window_, to == Direction::right);
    return from;
  }
  void let_go() override { light_.let_go(); }

 private:
  void lay_out_words(Page& page) {
    // The thrown size as a line, once the words say what it is.
    if (desk.glaze >= 0 && dried_ > 0.05) draw_ghost(page, picture_.camera(page), desk.made, {});
    const TypeScale& t = page.type();
    Column column(page, page.where().words);
    column.foot_buttons(standing_buttons(desk, true));
    column.foot_space(t.gap * 1.5f);
    const Button keep{"kiln.keep", desk.say("kiln.keep"), Look::solid};
    std::vector<Button> on{keep};
    if (!hides_.empty()) {
      on.push_back({has_section() ? kSection : "", desk.say(kSection),
                    place_          ? Look::chosen
                    : has_section() ? Look::outline
                                    : Look::resting});
      on.back().on = place_.has_value();
    }
    if (desk.glaze >= 0) {
      column.foot_buttons(on);
    } else {
      // Their room, so that no glaze moves when one is chosen.
      Page trial = page;
      Column other(trial, column.rest());
      other.foot_buttons(on);
      column.foot_space(column.rest().h - other.rest().h);
    }
    column.foot_space(t.gap * 1.5f);
    column.foot_buttons(glaze_buttons());
    column.foot_space(t.gap);

    // Controls matter more than text that was already spoken.
    if (!desk.screen().larger_text) {
      column.text(desk.answer(), t.body, Face::sans, view::kFaintInk);
      column.space(t.gap * 0.5f);
    }
    reserve_space(page, column.rest());
    if (desk.glaze < 0) {
      column.text(desk.say("kiln.title"), t.title, Face::serif);
      column.space(t.gap);
      column.text(desk.say(own_glaze() ? "kiln.choose_own" : "kiln.choose"), t.body);
      if (desk.decorated && !desk.decorated->bare()) {
        column.space(t.gap);
        column.text(desk.say("decorate.did", {{"what", did_in_words(desk, *desk.decorated)}}),
                    t.body, Face::sans, view::kFaintInk);
        column.text(hidden_in_words(), t.body, Face::sans, view::kFaintInk);
      }
      return;
    }
    const content::Glaze& glaze = chosen();
    if (place_)
      return lay_out_wall_section(column, desk, desk.decorated->way(),
                                  desk.decorated->layers_at(*place_), glaze);
    const view::Color ink = view::with_alpha(view::kInk, faded_in(chosen_at_));
    column.text(glaze.name_in(desk.words().code()), t.title, Face::serif, ink);
    column.space(t.gap);
    column.text(glaze.about_in(desk.words().code()), t.body, Face::sans, ink);
    column.space(t.gap);
    if (fired_ < 1)
      column.text(desk.say("kiln.firing"), t.body, Face::sans, view::kFaintInk);
    else
      column.text(shrank(), t.body, Face::sans, view::with_alpha(view::kInk, faded_in(told_at_)));
  }

  bool fired() const { return desk.glaze >= 0 && fired_ >= 1; }
  /// Glaze that lies on the pot melts: there is no choosing none.
  bool is_offered(int i) const {
    const auto melts = [this](int n) { return glaze_at(n).look.gloss >= kGlassy; };
    return !own_glaze() || melts(i) || std::ranges::none_of(kiln_.order, melts);
  }
  bool own_glaze() const { return desk.decorated && desk.decorated->glazed(); }
  /// A decorated pot's wall can be looked at once it is fired.
  bool has_section() const { return fired() && !hides_.empty(); }
  /// The light can be moved, and until it was moved a word at the foot of the picture says so.
  void lay_out_light(Page& page) const {
    if (desk.glaze < 0) return;
    const Regions& where = page.where();
    const TypeScale& t = page.type();
    const float foot = where.portrait ? where.words.y - 2.0f * t.gap : where.page.y + where.page.h;
    view::Rect picture = where.pot;
    picture.h = std::max(picture.h, foot - picture.y);
    page.control({kLight, picture, desk.say(kLight), {}, {}, true});
    if (!fired() || light_.moved()) return;
    const auto style = page.style(Face::serif, t.body, view::Align::centre);
    const std::string words = desk.say(kLight);
    const float high = page.size(words, style, picture.w).height;
    page.words({picture.x, foot - high, picture.w, high}, words, style,
               view::with_alpha(view::kFaintInk, faded_in(told_at_)));
  }
  /// The slips of a decorated pot get their fired colours while nobody sees more than its glow, and
  /// its glaze melts.
  void burn_slips(double dt) {
    if (!desk.decorated || desk.decorated->plain()) return;
    desk.decorated->heat();
    desk.decorated->fire(desk.glaze >= 0 && fired_ >= kHottest,
                         desk.glaze >= 0 && chosen().look.gloss >= kGlassy);
    desk.decorated->update(dt);
  }
  static std::string glaze_control(int i) { return "kiln.glaze." + std::to_string(i); }
  const content::Glaze& glaze_at(int i) const {
    return (*kiln_.glazes)[static_cast<std::size_t>(i)];
  }
  const content::Glaze& chosen() const { return glaze_at(desk.glaze); }
  view::Glazing glazing(int i) const { return {glaze_at(i).look, kiln_.coat}; }

  std::vector<Button> glaze_buttons() const {
    std::vector<Button> row;
    for (const int i : kiln_.order) {
      if (!is_offered(i)) continue;
      Button button{glaze_control(i), glaze_at(i).name_in(desk.words().code()),
                    i == desk.glaze ? Look::chosen : Look::outline};
      button.on = i == desk.glaze;
      button.swatch = display(content::swatch(glaze_at(i).look));
      row.push_back(std::move(button));
    }
    return row;
  }

  void finish() {
    dried_ = 1;
    if (desk.glaze < 0) return;
    fired_ = reglazed_ = 1;
    shown_ = desk.glaze;
  }

  std::string shrank() const {
    const double before = 1000 * desk.made.height(), left = kiln_.fired_size;
    const auto whole = [](double x) { return std::to_string(std::lround(x)); };
    // One decimal, unless it is zero: 12.5, 10.
    const std::string percent = hundredths(10 * std::lround(1000 * (1 - left)), desk.words());
    return desk.say(
        "kiln.shrank",
        {{"percent", percent}, {"before", whole(before)}, {"after", whole(before * left)}});
  }

  /// Which glazes hide the drawing; "" if none does.
  std::string hidden_in_words() const {
    std::string names;
    for (const int i : kiln_.order) {
      if (!is_offered(i) || !hides_[static_cast<std::size_t>(i)]) continue;
      const std::string& name = glaze_at(i).name_in(desk.words().code());
      names = names.empty() ? name : desk.say("all.list", {{"first", names}, {"second", name}});
    }
    return names.empty() ? names : desk.say("kiln.hides", {{"names", names}});
  }

  float faded_in(double since) const {
    if (desk.still()) return 1;
    return static_cast<float>(smooth((desk.now - since) / kTextFade));
  }

  /// Reserve space for the longest later text, so that its size need not shrink.
  void reserve_space(Page& page, const view::Rect& room) const {
    const TypeScale& t = page.type();
    float most = 0;
    const auto height = [&](const std::string& words, float px, Face face) {
      return page.size(words, page.style(face, px), std::min(room.w, px * 0.52f * 55.0f)).height;
    };
    for (const content::Glaze& glaze : *kiln_.glazes)
      most = std::max(most, height(glaze.name_in(desk.words().code()), t.title, Face::serif) +
                                height(glaze.about_in(desk.words().code()), t.body, Face::sans));
    const float last = std::max(height(shrank(), t.body, Face::sans),
                                height(desk.say("kiln.firing"), t.body, Face::sans));
    if (most + last + 2 * t.gap > room.h) page.overflowed();
  }

  const Kiln& kiln_;
  PotPicture picture_;
  MovedLight light_;
  double window_ = view::kWindowLeft;  // that the page wants
  std::vector<bool> hides_;            // by glaze: the drawing; empty for a plain pot
  double dried_ = 0, fired_ = 0, reglazed_ = 1;
  int shown_ = -1, before_ = -1;            // glazes on the pot
  view::Camera seen_;                       // that sees the pot at the size of its surface,
  double angle_ = 0;                        // and how far it is turned, rad
  std::optional<decorating::Place> place_;  // whose wall is shown
  bool tapped_ = false;                     // a finger is down, and has not moved from
  std::pair<float, float> tapped_at_{};
  double chosen_at_ = -10, told_at_ = -10;
};

}  // namespace

std::unique_ptr<Screen> make_kiln(Desk& desk) { return std::make_unique<KilnScreen>(desk); }

}  // namespace onggi::screens
