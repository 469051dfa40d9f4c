#pragma once

#include <string>
#include <vector>

#include "kiosk/picture/view/square_code.h"
#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// The label of a vessel over the shelf: its picture with credit and the museum's page, its text in
/// parts that fit, and the vessel most like it.
class VesselLabel {
 public:
  explicit VesselLabel(Desk& desk) : desk_(desk) {}
  /// Its card; -1: closed.
  int card() const { return card_; }
  /// Its mission, whose words come before the vessel's; -1: none.
  int mission() const { return mission_; }
  /// Finds the most similar vessel, once; never for a mission.
  void open(int card, int mission = -1);
  void close() { card_ = -1; }
  void lay_out(Page& page);
  /// The vessel may be built of coils before it may be thrown.
  bool offers_to_build() const;
  /// Reads on, or opens the most similar vessel's label; false for other controls.
  bool press(const std::string& control);

 private:
  std::vector<Button> ways_to_make() const;
  void lay_out_picture(Page& page, const ShelfCard& shelf, const content::Label& label,
                       view::Rect room);

  Desk& desk_;
  std::string coded_;      ///< The address in code_.
  view::SquareCode code_;  ///< Computed once for a label, not for each frame.
  int card_ = -1, mission_ = -1, part_ = 0, parts_ = 1;
  int alike_ = -1;  ///< The card with the most similar shape; -1: none is similar.
};

}  // namespace onggi::screens
