#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/collection/content/language.h"
#include "kiosk/picture/view/input.h"
#include "kiosk/visit/access/utterance.h"
#include "kiosk/visit/screens/reading.h"
#include "kiosk/wheel/device/asked_stroke.h"

namespace onggi::rehearsal {

/// What a visitor wants who makes a whole visit by names: a vessel or a mission, strokes where the
/// pot is told to be off or to want one, a glaze, the keepsake. How they come to a name is
/// BlindVisitor's and SwitchVisitor's.
class VisitPlan {
 public:
  /// `vessel`, or `mission`, and `glaze` by the names that the screens have for them. The pot is
  /// called done when it is close everywhere, or after `strokes`.
  struct Of {
    std::string vessel, mission, glaze;
  };
  VisitPlan(const content::Language& language, Of of, int strokes);

  /// Names of controls, any of which is the next; none: there is something to be waited for.
  std::vector<std::string> wanted() const;
  /// Leads to where they may be, if they are nowhere: a name.
  std::string instead() const { return language_->say("choose.next"); }
  /// `name` was chosen.
  void chosen(const std::string& name);
  /// Of the pot; true where it was understood.
  bool told(const std::string& text);
  /// At the wheel, and how the pot differs is not known.
  bool wonders() const { return step_ == Step::pot && !difference_; }
  bool over() const { return step_ == Step::over; }
  int strokes() const { return strokes_; }

 private:
  enum class Step { card, take, pot, finish, result, glaze, keep, leave, over };
  const content::Language* language_;
  Of of_;
  int most_, strokes_ = 0;
  Step step_ = Step::card;
  struct Wish {
    device::WallPart part;
    device::Ask ask;
  };
  std::optional<Wish> difference_;  ///< What is to be done about it.
  bool part_set_ = false, evened_ = false;
};

/// Hears, has keys and sees nothing: knows what is said and nothing else. A key held begins; then
/// it is Tab until the right name is heard, and Enter.
class BlindVisitor {
 public:
  static constexpr double kPace = 0.5;  ///< s between two keys.
  /// `hold`: s that the exhibit asks a key to be held.
  BlindVisitor(VisitPlan plan, double hold) : plan_(std::move(plan)), hold_(hold) {}
  void hear(const access::Utterance& said, double now);
  /// What is pressed now.
  std::vector<view::InputEvent> step(double now);
  const VisitPlan& plan() const { return plan_; }
  int presses() const { return presses_; }
  /// It finds no way on: the name that is nowhere.
  const std::string& lost() const { return lost_; }

 private:
  std::vector<view::InputEvent> press(view::Key key);

  VisitPlan plan_;
  double hold_;
  double began_at_ = -1, pressed_at_ = 0, waits_since_ = -1;
  bool begun_ = false;
  std::string on_;  ///< The control that was heard last.
  int tabs_ = 0, presses_ = 0;
  std::string lost_;
};

/// Sees, and has one switch: a touch anywhere, and no more.
class SwitchVisitor {
 public:
  static constexpr double kReaction = 0.25;  ///< s from what is shown to the press.
  SwitchVisitor(VisitPlan plan, double hold) : plan_(std::move(plan)), hold_(hold) {}
  /// `shown`: what the switch stands on.
  std::vector<view::InputEvent> step(const screens::Reading& reading,
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
