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

/// Sits between the visitor and the visit, for people who cannot see the screen or use one switch.
/// Without speech or switch it passes everything on unchanged. Knows no voice, clock or window.
/// Main thread.
class AccessMode {
 public:
  /// `hold`: Exhibit::Access::hold_to_speak.
  explicit AccessMode(double hold) : hold_(hold) {}

  /// Handles a window event. It passes it to the visit; with one switch it counts it as a press;
  /// with speech it explores with the finger. `px_per_mm` of the screen.
  void input(const view::InputEvent& event, screens::Visit& visit, double px_per_mm, double now);
  /// Call once per finished frame: draws the one switch's ring over it.
  void look(screens::Visit& visit, view::Frame& frame, double now);
  /// True once after a visitor asked for the pot's difference and it was spoken: it may now be
  /// played as pitch too.
  bool sings() { return std::exchange(sings_, false); }
  /// The next utterance; at most one a frame.
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
    int reached = 0;  ///< 1: speech is on; 2: one switch too.
  };
  std::optional<Hold> held_;
  std::string explored_;  ///< The last control under a finger.
  std::string armed_;     ///< The control that a finger touched twice.
  int asked_ = 0;
  bool song_waits_ = false, sings_ = false;
  bool on_pot_ = false;  ///< The finger is on the clay.
};

}  // namespace onggi::access
