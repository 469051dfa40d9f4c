#pragma once

namespace onggi::screens {

/// Motion of a shelf that is wider than the screen, under a finger: in columns, the first at 0.
/// While held it follows the finger, beyond its ends at a third of the finger's motion. After
/// release it continues at its speed, slows down, and stops with a whole column in front. Main
/// thread; no clock.
class ShelfScroll {
 public:
  /// The shelf has `columns`, of which `shown` fit whole on the screen.
  void bound(int columns, int shown);
  /// The front column, with a fraction while it moves.
  double at() const { return at_; }
  /// The front column after it stops.
  int first() const { return to_; }
  int shown() const { return shown_; }
  int columns() const { return columns_; }
  bool longer_than_the_screen() const { return columns_ > shown_; }
  bool at_the_end() const { return to_ >= last(); }
  /// True if its motion is visible, or it is held.
  bool moving() const { return held_ || at_ - to_ > kSeen || to_ - at_ > kSeen; }

  /// A finger stops it.
  void hold();
  /// The finger moved it by this many columns, positive onward.
  void drag(double columns);
  /// The finger released it at this many columns a second.
  void release(double speed);
  /// Moves on by this many columns, up to its ends.
  void step(int columns);
  void show(int column);
  /// Advances by `dt` seconds. `still`: jumps to its goal.
  void update(double dt, bool still);

 private:
  static constexpr double kSeen = 0.02;  // columns
  int last() const { return columns_ > shown_ ? columns_ - shown_ : 0; }
  int within(double column) const;

  int columns_ = 1, shown_ = 1;
  double at_ = 0;
  int to_ = 0;
  bool held_ = false;
};

}  // namespace onggi::screens
