#pragma once

namespace onggi::screens {

/// How a shelf that is wider than the screen moves under a finger: in columns, the first at 0.
/// Held, it goes where the finger goes, beyond its ends a third as far; let go, it runs on as fast
/// as it was going, loses way, and comes to rest with a whole column in front. Main thread; no
/// clock.
class ShelfScroll {
 public:
  /// The shelf has `columns`, of which `shown` stand whole on the screen.
  void bound(int columns, int shown);
  /// Which column stands in front, a part of one while it moves.
  double at() const { return at_; }
  /// Which will, once it rests.
  int first() const { return to_; }
  int shown() const { return shown_; }
  int columns() const { return columns_; }
  bool longer_than_the_screen() const { return columns_ > shown_; }
  bool at_the_end() const { return to_ >= last(); }
  /// So that one sees it, or held.
  bool moving() const { return held_ || at_ - to_ > kSeen || to_ - at_ > kSeen; }

  /// A finger stops it where it is.
  void hold();
  /// It moved it by so many columns, positive onward.
  void drag(double columns);
  /// And let go at so many columns a second.
  void release(double speed);
  /// Onward by so many columns, as far as there are any.
  void step(int columns);
  /// Is there at once, with `column` among what is shown.
  void show(int column);
  /// Seconds pass; `still`: it is there at once.
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
