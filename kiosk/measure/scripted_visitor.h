#pragma once

#include <functional>
#include <memory>
#include <string>

#include "kiosk/exhibit/kiosk.h"
#include "kiosk/measure/visitors_hand.h"

namespace onggi::measure {

/// A visitor who needs no person: touches the screens' own controls, lets a script move the hands,
/// and keeps the picture. One step a frame, after Kiosk::frame().
class ScriptedVisitor {
 public:
  struct Plan {
    std::string script = "follow";
    int card = 0;   ///< Of the shelf.
    int glaze = 0;  ///< Of the exhibit's, where the scene has a kiln.
    std::uint64_t seed = 1;
    double pace = 1.0;    ///< Of the script.
    double linger = 2.0;  ///< Seconds spent looking at each screen.
    /// Who moves the hands: the script itself in the loop; or as VisitorsHand does; or a device
    /// alone, at which the visitor looks on for `watch` seconds.
    enum class Hand : std::uint8_t { script, pointer, device, device_alone } hand = Hand::script;
    double watch = 30.0;
  };
  /// `passed(name)` is called at the moment a screen is worth a picture, once a name.
  ScriptedVisitor(exhibit::Kiosk& kiosk, Plan plan, std::function<void(const std::string&)> passed);

  /// After the frame at `now`; gives input to the visit. Problem when the visit stands where no
  /// visitor would be left: a fault, a control that is missing, a keepsake that could not be kept.
  Result<void> step(double now);
  /// Back at attract with the keepsake safe.
  bool done() const { return done_; }
  /// The script moves the visitor's hands.
  bool throwing() const { return playing_; }
  /// 0..1 of the throwing.
  double progress() const;

 private:
  void enter(screens::ScreenId screen, double now);
  Result<void> on_choose();
  Result<void> on_throw(double now);
  Result<void> begin_throwing(double now);
  Result<void> on_kiln();
  Result<void> on_keepsake();
  Result<void> touch(const std::string& control);
  void touch_at(float x, float y);
  void pass(const std::string& name) {
    if (passed_) passed_(name);
  }

  exhibit::Kiosk& kiosk_;
  Plan plan_;
  std::function<void(const std::string&)> passed_;
  screens::ScreenId screen_ = screens::ScreenId::attract;
  double entered_ = -1, now_ = 0, moved_at_ = 0;
  std::unique_ptr<VisitorsHand> hand_;  ///< Null where the loop plays the script.
  bool label_open_ = false, playing_ = false, half_shown_ = false, touched_ = false,
       kept_seen_ = false;
  bool done_ = false;
};

}  // namespace onggi::measure
