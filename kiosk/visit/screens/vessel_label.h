#pragma once

#include <string>

#include "kiosk/picture/view/square_code.h"
#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// The label of a vessel over the shelf: its picture with whose it is and the museum's page, its
/// text in parts that fit, and the vessel most like it.
class VesselLabel {
 public:
  explicit VesselLabel(Desk& desk) : desk_(desk) {}
  /// Of which card; -1: none is open.
  int card() const { return card_; }
  /// And of which mission, whose words stand before the vessel's; -1: of none.
  int mission() const { return mission_; }
  /// Which other vessel is most like it is asked once, of a mission never.
  void open(int card, int mission = -1);
  void close() { card_ = -1; }
  void lay_out(Page& page);
  /// Reads on, or opens the vessel most like it; false for other controls.
  bool press(const std::string& control);

 private:
  void lay_out_picture(Page& page, const ShelfCard& shelf, const content::Label& label,
                       view::Rect room);

  Desk& desk_;
  std::string coded_;      ///< The address that code_ is of.
  view::SquareCode code_;  ///< Reckoned once for a label, not once a frame.
  int card_ = -1, mission_ = -1, part_ = 0, parts_ = 1;
  int alike_ = -1;  ///< The card whose shape is most like the open one's; -1: none is alike.
};

}  // namespace onggi::screens
