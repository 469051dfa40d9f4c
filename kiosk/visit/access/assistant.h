#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/picture/view/input.h"
#include "kiosk/visit/access/narrator.h"
#include "kiosk/visit/access/scan.h"
#include "kiosk/visit/access/utterance.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::access {

/// Stands between a visitor and the visit for whoever does not see the screen or has one switch.
/// Without either it hands everything on as it came. Knows no voice, clock or window. Main thread.
class Assistant {
 public:
  /// `hold`: Exhibit::Access::hold_to_speak.
  explicit Assistant(double hold) : hold_(hold) {}

  /// An event of the window. Handed on to the visit, or: of one switch a press; of a visitor to
  /// whom is read, a finger that explores. `px_per_mm` of the screen.
  void input(const view::InputEvent& event, screens::Visit& visit, double px_per_mm, double now);
  /// Once a frame, when it has been made: what the switch stands on is drawn over it.
  void look(screens::Visit& visit, view::Frame& frame, double now);
  /// Once, when it was asked how the pot differs and that has been said: now it may be heard as
  /// pitch, too.
  bool sings() { return std::exchange(sings_, false); }
  /// What is to be said now; at most one thing a frame.
  std::optional<Utterance> take();
  void ended(std::uint64_t id) { narrator_.ended(id); }
  const Scan& scan() const { return scan_; }

 private:
  void watch_hold(const view::InputEvent& event, const screens::Visit& visit, double px_per_mm,
                  double now);
  void held(screens::Visit& visit, double now);
  void press_switch(screens::Visit& visit, double now);
  void explore(const view::InputEvent& event, screens::Visit& visit, double px_per_mm, double now);
  void ask(screens::Visit& visit, double now);

  double hold_;
  Scan scan_;
  Narrator narrator_;
  std::optional<Utterance> next_;
  struct Hold {
    double since = 0;
    float x = 0, y = 0;
    bool key = false;
    int reached = 0;  ///< 1: it is read aloud; 2: one switch.
  };
  std::optional<Hold> held_;
  std::string explored_;  ///< What a finger came to last.
  std::string armed_;     ///< What a finger came down on for the second time.
  int asked_ = 0;
  bool song_waits_ = false, sings_ = false;
  bool on_pot_ = false;  ///< It is on the clay.
};

}  // namespace onggi::access
