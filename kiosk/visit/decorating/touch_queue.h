#pragma once

#include <deque>

#include "kiosk/visit/decorating/decorated_pot.h"

namespace onggi::decorating {

/// A finger on a pot that may be busy: what it does meanwhile is kept, the pot hurries, and then it
/// is done where the finger was. So no touch is lost. Main thread. Allocates.
class TouchQueue {
 public:
  /// `pot` outlives it.
  explicit TouchQueue(DecoratedPot& pot) : pot_(pot) {}

  // As the pot's.
  void press(const Place& at) { take({Touch::down, at}); }
  void move(const Place& at) { take({Touch::moved, at}); }
  void lift() { take({Touch::up, {}}); }
  void put(const Place& at) { take({Touch::button, at}); }
  void cancel();
  /// Once a frame: goes on with the pot's work, then with the kept touches.
  void update(double dt, bool hurry = false);
  /// True while touches are kept.
  bool waits() const { return !kept_.empty(); }
  /// Does all at once: before another tool or colour is taken.
  void settle();

 private:
  struct Touch {
    enum Kind { down, moved, up, button } kind = down;
    Place at;
  };
  void take(const Touch& touch);
  void hand_over(const Touch& touch);
  void hand_over_kept();

  DecoratedPot& pot_;
  std::deque<Touch> kept_;
};

}  // namespace onggi::decorating
