#pragma once

namespace onggi::screens {

/// Notices when nobody is there. Any input restarts the wait, at any time.
class IdleWatch {
 public:
  enum class Word { none, warn, over };
  void touched(double now) {
    last_ = now;
    started_ = true;
  }
  /// `warn_after` s without input before the warning, then `countdown` s (at least 20).
  Word look(double now, double warn_after, double countdown);
  double seconds_left() const { return left_; }
  double countdown() const { return countdown_; }

 private:
  bool started_ = false;
  double last_ = 0, left_ = 0, countdown_ = 20;
};

}  // namespace onggi::screens
