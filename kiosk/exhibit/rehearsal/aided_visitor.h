#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/collection/content/language.h"
#include "kiosk/picture/view/input.h"
#include "kiosk/visit/access/utterance.h"
#include "kiosk/visit/screens/screen_text.h"
#include "kiosk/wheel/device/asked_stroke.h"

namespace onggi::rehearsal {

/// The plan of a visitor who makes a whole visit by names: a vessel or a mission, strokes where the
/// pot is said to be off, a glaze, the keepsake. BlindVisitor and SwitchVisitor reach the names in
/// their own ways.
class VisitPlan {
 public:
  /// `vessel`, or `mission`, and `glaze`, by their names on the screens. The pot is called done
  /// when it is close everywhere, or after `strokes`.
  struct Of {
    std::string vessel, mission, glaze;
    bool built = false;  ///< It may be built of coils, too.
  };
  VisitPlan(const content::Language& language, Of of, int strokes);

  /// Names of the controls that may come next; empty: wait.
  std::vector<std::string> wanted() const;
  /// The name that leads there if none of them is on the screen.
  std::string instead() const { return language_->say("choose.next"); }
  /// `name` was activated.
  void chosen(const std::string& name);
  /// Hears a text about the pot; true if it was understood.
  bool told(const std::string& text);
  /// True at the wheel while the pot's difference is not known.
  bool wonders() const { return step_ == Step::pot && !difference_; }
  bool over() const { return step_ == Step::over; }
  int strokes() const { return strokes_; }

 private:
  enum class Step { card, take, pot, finish, result, decorate, glaze, keep, leave, over };
  const content::Language* language_;
  Of of_;
  int most_, strokes_ = 0;
  Step step_ = Step::card;
  struct Wish {
    device::WallPart part;
    device::Ask ask;
  };
  std::optional<Wish> difference_;  ///< The next stroke.
  bool part_set_ = false, evened_ = false;
};

/// A visitor who hears, has keys and sees nothing, so it knows only what is spoken. It holds a key
/// to begin, then presses Tab until it hears the right name, and Enter.
class BlindVisitor {
 public:
  static constexpr double kPace = 0.5;  ///< s between two keys.
  /// `hold`: s that the exhibit requires for holding a key.
  BlindVisitor(VisitPlan plan, double hold) : plan_(std::move(plan)), hold_(hold) {}
  void hear(const access::Utterance& said, double now);
  /// The key that it presses now.
  std::vector<view::InputEvent> step(double now);
  const VisitPlan& plan() const { return plan_; }
  int presses() const { return presses_; }
  /// It is stuck: this name was never heard.
  const std::string& lost() const { return lost_; }

 private:
  std::vector<view::InputEvent> press(view::Key key);

  VisitPlan plan_;
  double hold_;
  double began_at_ = -1, pressed_at_ = 0, waits_since_ = -1;
  bool begun_ = false;
  std::string on_;  ///< The last control that it heard.
  int tabs_ = 0, presses_ = 0;
  std::string lost_;
};

/// A visitor who sees and has one switch: a touch anywhere.
class SwitchVisitor {
 public:
  static constexpr double kReaction = 0.25;  ///< s from seeing a choice to pressing.
  SwitchVisitor(VisitPlan plan, double hold) : plan_(std::move(plan)), hold_(hold) {}
  /// `shown`: the controls that the switch offers.
  std::vector<view::InputEvent> step(const screens::ScreenText& reading,
                                     const std::vector<std::string>& shown, double now);
  const VisitPlan& plan() const { return plan_; }
  int presses() const { return presses_; }

 private:
  VisitPlan plan_;
  double hold_;
  double began_at_ = -1, shown_since_ = -1;
  bool begun_ = false;
  std::vector<std::string> shown_;
  int presses_ = 0;
};

}  // namespace onggi::rehearsal
