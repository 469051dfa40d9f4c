#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/visit/screens/reading.h"

namespace onggi::access {

/// One switch for everything: the rows of what can be chosen are shown in turn, a press of the
/// switch goes into the row that is shown, and then its items come in turn, until one is pressed or
/// none was for two rounds. Knows no clock, window or visit. Main thread.
class Scan {
 public:
  /// The first of a row, and the first row, stay half as long again: who pressed must come to rest.
  static constexpr double kFirst = 1.5;
  /// s after a press in which another is a tremble.
  static constexpr double kTremble = 0.2;
  static constexpr int kRounds = 2;

  /// Once a frame: `reading` as it stands, which says how long each stays.
  void look(const screens::Reading& reading, double now);
  /// The switch; gives the control that was chosen with it.
  std::optional<std::string> press(const screens::Reading& reading, double now);
  /// What is shown now: a row's controls, or one.
  const std::vector<std::string>& shown() const { return shown_; }
  bool in_a_row() const { return in_row_; }
  /// Begins anew with the row in which the keyboard would.
  void restart() { ids_.clear(); }

 private:
  void show(const screens::Reading& reading, double now);
  bool changed(const screens::Reading& reading);

  std::vector<std::string> ids_;  ///< Of what is stepped through.
  std::vector<std::vector<std::size_t>> rows_;
  std::vector<std::string> shown_;
  std::string screen_;
  std::size_t row_ = 0, item_ = 0;
  bool in_row_ = false, fresh_ = true;
  int rounds_ = 0;
  double since_ = 0, pressed_at_ = -10;
};

}  // namespace onggi::access
