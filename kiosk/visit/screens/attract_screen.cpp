#include "kiosk/visit/screens/attract_screen.h"

#include <algorithm>
#include <memory>

#include "engine/script/coiling.h"
#include "kiosk/visit/screens/demonstration.h"
#include "kiosk/visit/screens/gallery_page.h"
#include "kiosk/visit/screens/label.h"
#include "kiosk/visit/screens/overlays.h"
#include "kiosk/visit/screens/pot_picture.h"
#include "kiosk/visit/screens/stroke_board.h"

namespace onggi::screens {

using view::Face;

namespace {

constexpr double kRest = 7.0;       // s that a finished pot is shown with its name
constexpr double kNameFade = 1.2;   // s
constexpr double kGallery = 10.0;   // s that today's pots are shown between two pots,
constexpr double kLookedAt = 60.0;  // and after the last touch of a visitor who looks at them

/// A potter's hands throw a pot; its name fades in at the end; then the next vessel follows. Now
/// and then a script shows an effect of clay, with a line about it. Today's pots are shown after
/// each pot or on request.
class Attract final : public Screen {
 public:
  explicit Attract(Desk& d) : Screen(d), picture_(std::make_shared<PotPicture>()), gallery_(d) {
    desk.attract_picture = picture_;
  }
  ScreenId id() const override { return ScreenId::attract; }
  std::string first_focus() const override { return "attract.begin"; }
  void press(const std::string& control) override {
    seen_at_ = desk.now;
    if (control == "attract.begin") desk.go(ScreenId::choose);
    if (control == "attract.gallery") turn_to(Shows::gallery);
    if (shows_ == Shows::gallery) gallery_.press(control);
  }
  void back() override { turn_to(Shows::pot); }
  /// On the clay it presses the clay at once. Strokes by buttons begin there too.
  void begin(const view::InputEvent& e) override {
    using view::Key;
    const bool arrow =
        e.kind == view::InputEvent::Kind::key_down &&
        (e.key == Key::left || e.key == Key::right || e.key == Key::up || e.key == Key::down);
    const bool pot = asked_ && desk.pot_ready() && shows_ == Shows::pot;
    if (pot && (arrow || works(e))) desk.began_on_clay = {e, camera_};
    const bool clay = desk.began_on_clay || (pot && StrokeBoard::wanted(desk));
    desk.go(clay ? ScreenId::clay : ScreenId::choose);
  }
  bool works(const view::InputEvent& e) const override {
    if (shows_ != Shows::pot || !asked_ || !desk.pot_ready()) return false;
    return e.kind == view::InputEvent::Kind::pointer_down &&
           picture_->on_clay(camera_.on_axis_plane(e.x, e.y));
  }
  /// A visitor who asked for today's pots can move and touch them; otherwise any touch begins a
  /// visit.
  bool begins_with(const std::string& control) const override {
    return shows_ != Shows::gallery ? control != "attract.gallery" : control == "attract.begin";
  }
  bool drag(const view::InputEvent& e, const Page&) override {
    if (shows_ != Shows::gallery) return false;
    seen_at_ = desk.now;
    return gallery_.drag(e);
  }
  void pointer(const view::InputEvent& e, const Page&) override {
    if (shows_ == Shows::gallery) gallery_.pointer(e);
  }
  void let_go() override {
    if (show_ && desk.pot_ready()) show_->let_go(*desk.world.wheel_commands);
  }

  void update(double dt) override {
    gallery_.update(dt);
    if (shows_ != Shows::pot) {
      const double most = shows_ == Shows::gallery ? kLookedAt : kGallery;
      if (desk.now - seen_at_ > most || !gallery_.any()) turn_to(Shows::pot);
    }
    if (!asked_ || (done_at_ >= 0 && desk.now - done_at_ > kRest)) {
      if (asked_ && shows_ == Shows::pot && gallery_.any()) turn_to(Shows::interlude);
      next_pot();
    }
    const ShelfCard* card = desk.shelf_card(desk.attract_card);
    picture_->update(desk, dt, card != nullptr ? &card->target : nullptr, false, false);
    if (!asked_ || !desk.pot_ready() || card == nullptr) return;
    if (show_) {
      Vec3 right, up, back;
      camera_.basis(right, up, back);
      show_->update(dt, *desk.world.wheel, card->target, right, *desk.world.wheel_commands);
    }
    if (done_at_ < 0 && (show_ ? show_->done() : desk.status.script_done)) done_at_ = desk.now;
  }

  std::optional<view::PotView> pot(const Page& page) override {
    if (!asked_ || shows_ != Shows::pot) return std::nullopt;
    view::PotView pot = picture_->view(desk, page);
    pot.coil = desk.world.wheel->coil;
    if (done_at_ >= 0 && !desk.still())
      pot.opacity *= std::clamp((done_at_ + kRest - desk.now) / 0.5, 0.0, 1.0);
    return pot;
  }

  void lay_out(Page& page) override {
    camera_ = picture_->camera(page);
    const Button begin{"attract.begin", desk.say("attract.begin"), Look::solid};
    if (shows_ != Shows::pot) return gallery_.lay_out(page, {begin}, shows_ == Shows::gallery);
    const TypeScale& t = page.type();
    Column column(page, page.where().words);
    column.foot_buttons(standing_buttons(desk, false));
    column.foot_space(t.gap * 2);
    std::vector<Button> ways{begin};
    if (gallery_.any()) ways.push_back(gallery_.way("attract.gallery"));
    column.foot_buttons(ways);
    column.foot_space(t.gap * 2);
    column.text(desk.title(), t.display, Face::serif);
    column.space(t.gap);
    column.text(desk.say("attract.lead"), t.body);

    // Reserve space for the name at all times, so that nothing moves when it appears.
    if (!asked_) return;
    if (!follows() && !(desk.attract_builds && done_at_ >= 0)) {
      column.space(t.gap * (page.where().portrait ? 1.5f : 3.0f));
      column.text(desk.say("attract." + script_), t.body, Face::sans, view::kFaintInk);
      return;
    }
    const content::Label label = desk.label(desk.attract_card);
    const float alpha = name_alpha();
    Page unseen = page;
    Page& onto = alpha > 0.004f ? page : unseen;
    Column name(onto, column.rest());
    name.space(t.gap * (page.where().portrait ? 1.5f : 3.0f));
    name.text(desk.say("attract.thrown"), t.body, Face::sans,
              view::with_alpha(view::kFaintInk, alpha));
    name.text(label.title, t.title, Face::serif, view::with_alpha(view::kInk, alpha));
    for (const std::string& line : under_title(label))
      name.text(line, t.body, Face::sans, view::with_alpha(view::kFaintInk, alpha));
    if (unseen.overflow()) page.overflowed();
  }

 private:
  void next_pot() {
    if (desk.cards() == 0) return;
    desk.attract_card = (desk.attract_card + 1) % desk.cards();
    const ShelfCard& card = *desk.shelf_card(desk.attract_card);
    const SceneForVisitor& wheel = card.wheel;
    script_ = wheel.shown[desk.attract_turn++ % wheel.shown.size()];
    // As its makers made it, if that comes near the vessel without hands that follow.
    desk.attract_builds =
        card.built && follows() &&
        (card.built->beating || script::coils_come_near(card.target, *card.built->coil));
    if (desk.attract_builds) script_ = "build";
    // If clay keeps its volume, the pot's height needs planning, so the script throws it.
    show_.reset();
    if (follows() && !wheel.keeps_clay) show_.emplace(wheel, desk.screen().left_handed);
    desk.start_pot(desk.attract_card, true, show_ ? "" : script_);
    asked_ = true;
    done_at_ = -1;
  }

  enum class Shows { pot, interlude, gallery };
  void turn_to(Shows to) {
    if (shows_ == to) return;
    shows_ = to;
    seen_at_ = desk.now;
    gallery_.begin();
    desk.turned = true;
  }

  float name_alpha() const {
    if (done_at_ < 0) return 0;
    if (desk.still()) return 1;
    const double in = (desk.now - done_at_) / kNameFade, out = (done_at_ + kRest - desk.now) / 0.5;
    return static_cast<float>(std::clamp(std::min(in, out), 0.0, 1.0));
  }

  bool follows() const { return script_ == "follow"; }

  std::shared_ptr<PotPicture> picture_;
  GalleryPage gallery_;
  Shows shows_ = Shows::pot;
  double seen_at_ = 0;  ///< When the gallery was opened or last touched.
  view::Camera camera_;
  std::optional<Demonstration> show_;
  std::string script_ = "follow";
  bool asked_ = false;
  double done_at_ = -1;
};

}  // namespace

std::unique_ptr<Screen> make_attract(Desk& desk) { return std::make_unique<Attract>(desk); }

}  // namespace onggi::screens
