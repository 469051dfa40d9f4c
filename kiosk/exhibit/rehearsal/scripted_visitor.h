#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/rehearsal/handsome.h"
#include "kiosk/exhibit/rehearsal/naive_hands.h"
#include "kiosk/exhibit/rehearsal/two_visitors.h"
#include "kiosk/exhibit/rehearsal/visitors_hand.h"

namespace onggi::rehearsal {

/// A visitor who needs no person: touches the screens' own controls, lets a script move the hands,
/// and keeps the picture. One step a frame, after Kiosk::frame().
class ScriptedVisitor {
 public:
  struct Naive {
    double seconds = 90;  ///< Until the pot is called done, 5 to 600.
    NaiveHands::Pointer pointer = NaiveHands::Pointer::mouse;
  };
  struct Plan {
    std::string script = "follow";
    std::optional<Naive> naive;  ///< Instead of the script: strokes on the screen, by the seed.
    bool two = false;            ///< Likewise: strokes of two visitors, a finger each.
    int card = 0;                ///< Of the shelf.
    int mission = -1;            ///< Instead: of the missions that are on.
    int glaze = 0;               ///< Of the exhibit's, where the scene has a kiln.
    std::uint64_t seed = 1;
    double pace = 1.0;    ///< Of the script.
    double linger = 2.0;  ///< Seconds spent looking at each screen.
    /// Who moves the hands: the script itself in the loop; or as VisitorsHand does; or a device
    /// alone, at which the visitor looks on for `watch` seconds.
    enum class Hand : std::uint8_t { script, pointer, device, device_alone } hand = Hand::script;
    double watch = 30.0;
  };
  /// Of a naive visitor's pot: as it was called done, and when it first was one to be proud of:
  /// handsome, and 4 mm off the lump that it came from.
  struct Looks {
    Smoothness end;
    std::optional<double> handsome_at;  ///< s since the first look at the wheel.
  };
  /// `passed(name)` is called at the moment a screen is worth a picture, once a name.
  ScriptedVisitor(exhibit::Kiosk& kiosk, Plan plan, std::function<void(const std::string&)> passed);

  /// After the frame at `now`; gives input to the visit. Problem when the visit stands where no
  /// visitor would be left: a fault, a control that is missing, a keepsake that could not be kept.
  Result<void> step(double now);
  /// Back at attract with the keepsake safe.
  bool done() const { return done_; }
  /// The visitor's hands are at work.
  bool throwing() const { return playing_; }
  /// How far, 0 to 1.
  double progress() const;
  /// Nothing before a naive visitor's pot is done.
  const std::optional<Looks>& looks() const { return looks_; }

 private:
  void enter(screens::ScreenId screen, double now);
  Result<void> on_choose();
  Result<void> on_throw(double now);
  Result<void> begin_throwing(double now);
  Result<void> on_naive(double now);
  Result<void> on_two(double now);
  Result<void> on_kiln();
  Result<void> on_keepsake();
  Result<void> touch(const std::string& control);
  void pass(const std::string& name) {
    if (passed_) passed_(name);
  }

  exhibit::Kiosk& kiosk_;
  Plan plan_;
  std::function<void(const std::string&)> passed_;
  screens::ScreenId screen_ = screens::ScreenId::attract;
  std::string then_;  ///< A control to be touched in the next frame.
  double entered_ = -1, now_ = 0, moved_at_ = 0;
  std::unique_ptr<VisitorsHand> hand_;  ///< Null where the loop plays the script.
  bool label_open_ = false, playing_ = false, half_shown_ = false, touched_ = false,
       kept_seen_ = false;
  bool done_ = false;
  std::optional<NaiveHands> hands_;
  std::optional<TwoVisitors> two_;
  std::optional<Looks> looks_;
  Profile lump_;  ///< As it lay on the wheel.
  double looked_at_ = 0, troubled_at_ = -1;
};

}  // namespace onggi::rehearsal
