#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/rehearsal/decorating_hand.h"
#include "kiosk/exhibit/rehearsal/looks_smooth.h"
#include "kiosk/exhibit/rehearsal/naive_decorator.h"
#include "kiosk/exhibit/rehearsal/naive_hands.h"
#include "kiosk/exhibit/rehearsal/two_player_script.h"
#include "kiosk/exhibit/rehearsal/visitors_hand.h"

namespace onggi::rehearsal {

/// A visitor without a person: touches the screens' own controls, lets a script move the hands, and
/// saves the keepsake. One step a frame, after Kiosk::frame().
class ScriptedVisitor {
 public:
  struct Naive {
    double seconds = 90;  ///< When the pot is called done, 5 to 600.
    NaiveHands::Pointer pointer = NaiveHands::Pointer::mouse;
  };
  struct Plan {
    std::string script = "follow";
    std::optional<Naive> naive;  ///< Instead of the script: strokes on the screen, by the seed.
    bool two = false;            ///< Instead of the script: strokes of two visitors, a finger each.
    int card = 0;                ///< On the shelf.
    int mission = -1;            ///< Instead of a card: index among the missions that are on.
    int glaze = 0;               ///< Index in the exhibit's glazes, if the scene has a kiln.
    bool decorate = false;  ///< Decorates the pot, if its vessel has a way; else leaves it plain.
    /// Instead of a careful hand: clumsy strokes by the seed, for so many seconds, 5 to 600.
    std::optional<double> clumsy;
    std::uint64_t seed = 1;
    double pace = 1.0;    ///< The script's.
    double linger = 2.0;  ///< Seconds at each screen.
    /// What moves the hands: the script in the loop; or VisitorsHand; or only a device, while the
    /// visitor looks on for `watch` seconds.
    enum class Hand : std::uint8_t { script, pointer, device, device_alone } hand = Hand::script;
    double watch = 30.0;
  };
  /// A naive visitor's pot: when it was called done, and when it first looked good, which means
  /// handsome and 4 mm off the original lump.
  struct Looks {
    Smoothness end;
    std::optional<double> handsome_at;  ///< s since the wheel's first frame.
  };
  /// Calls `passed(name)` once for each screen worth a picture.
  ScriptedVisitor(exhibit::Kiosk& kiosk, Plan plan, std::function<void(const std::string&)> passed);

  /// Call after the frame at `now`; sends input to the visit. Problem if the visit is stuck: a
  /// fault, a missing control, a keepsake that could not be saved.
  Result<void> step(double now);
  /// True at attract with the keepsake saved.
  bool done() const { return done_; }
  /// True while the visitor's hands work.
  bool throwing() const { return playing_; }
  /// Progress, 0 to 1.
  double progress() const;
  /// Absent before a naive visitor's pot is done.
  const std::optional<Looks>& looks() const { return looks_; }

 private:
  void enter(screens::ScreenId screen, double now);
  Result<void> on_choose();
  Result<void> on_throw(double now);
  Result<void> begin_throwing(double now);
  Result<void> on_naive(double now);
  Result<void> on_two(double now);
  Result<void> on_decorate();
  /// True once the pot is decorated.
  bool decorated(const decorating::DecoratedPot& pot) const;
  Result<void> decorate(const decorating::DecoratedPot& pot);
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
  std::string then_;  ///< The control to touch in the next frame.
  double entered_ = -1, now_ = 0, moved_at_ = 0;
  double furthest_ = 0, furthest_at_ = 0;  // the script's progress, and when it last grew
  std::unique_ptr<VisitorsHand> hand_;     ///< Null if the loop plays the script.
  bool label_open_ = false, playing_ = false, half_shown_ = false, touched_ = false,
       kept_seen_ = false;
  bool done_ = false;
  std::optional<NaiveHands> hands_;
  std::optional<TwoPlayerScript> two_;
  std::optional<DecoratingHand> decorating_;
  std::optional<NaiveDecorator> clumsy_;
  std::optional<std::pair<float, float>> finger_;  ///< Of decorating_, where it is down.
  std::optional<Looks> looks_;
  Profile lump_;  ///< The fresh lump.
  double looked_at_ = 0, troubled_at_ = -1;
};

}  // namespace onggi::rehearsal
