#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/visit/screens/screen_text.h"

namespace onggi::access {

/// One switch for everything. The rows of controls are offered in turn; a press enters the offered
/// row, and its items are offered in turn, until a press chooses one or two rounds pass. Knows no
/// clock, window or visit. Main thread.
class Scan {
 public:
  /// The first row, and the first item of a row, stay 1.5 times as long, because the visitor needs
  /// time after a press.
  static constexpr double kFirst = 1.5;
  /// s after a press during which another press counts as a tremble.
  static constexpr double kTremble = 0.2;
  static constexpr int kRounds = 2;

  /// Call once a frame with the current `reading`, which sets how long each item stays.
  void look(const screens::ScreenText& reading, double now);
  /// The switch was pressed; returns the chosen control.
  std::optional<std::string> press(const screens::ScreenText& reading, double now);
  /// The controls offered now: a whole row, or one.
  const std::vector<std::string>& shown() const { return shown_; }
  bool in_a_row() const { return in_row_; }
  /// Starts again with the row where the keyboard would start.
  void restart() { ids_.clear(); }

 private:
  void show(const screens::ScreenText& reading, double now);
  bool changed(const screens::ScreenText& reading);

  std::vector<std::string> ids_;  ///< Ids of the controls in the current rows.
  std::vector<std::vector<std::size_t>> rows_;
  std::vector<std::string> shown_;
  std::string screen_;
  std::size_t row_ = 0, item_ = 0;
  bool in_row_ = false, fresh_ = true;
  int rounds_ = 0;
  double since_ = 0, pressed_at_ = -10;
};

}  // namespace onggi::access
