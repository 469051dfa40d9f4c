#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/wheel/device/asked_stroke.h"

namespace onggi::screens {

/// Difference of a part of the pot from the target, as a mean over the part: m of diameter on the
/// wheel, positive if too wide.
struct PartOff {
  device::WallPart part = device::WallPart::middle;
  double off = 0;
  bool near = true;  ///< Close enough to count as alike.
};
/// The differences of the five parts, from the foot up, between `made` on the wheel, m, and the
/// card's target. If `made` is empty, all are near. Empty if there is no card.
std::vector<PartOff> parts_off(const ShelfCard* card, const Profile& made);

/// Strokes for a visitor who does not draw: buttons for the place and for what the hands do there,
/// and one that tells where the pot differs. The visitor's own two hands make the stroke.
///  Controls: "throw.part.N" (WallPart), "throw.ask.N" (Ask), "throw.tell".
class StrokeBoard {
 public:
  /// True if this visitor has the board: with "Read aloud" and "One switch".
  static bool wanted(const Desk& desk);
  static constexpr const char* kFirst = "throw.part.2";

  /// Handles one of its controls. Returns the stroke if one was asked for.
  std::optional<device::Ask> press(const std::string& control);
  device::WallPart part() const { return part_; }
  bool begun() const { return begun_; }
  /// How often the visitor asked where the pot differs.
  int asked() const { return asked_; }

  /// Laid out from the foot of `column` up. Its sentence comes before everything else on the page:
  /// the current action, or after a question the pot's difference, or else `hint`. `ways`: the
  /// buttons to the drawers.
  void lay_out(Column& column, const Desk& desk, const std::vector<Button>& ways,
               const std::vector<PartOff>& parts, bool working, const std::string& hint) const;
  /// Advice for a pot that should answer a description: the stroke and its part, by the names of
  /// their buttons. "" if there is no description, or nothing is known.
  static std::string advice(const Desk& desk);
  /// The whole pot in words, worst part first: at most `most` sentences. With a description: its
  /// figures, and advice().
  static std::vector<std::string> told(const Desk& desk, const std::vector<PartOff>& parts,
                                       std::size_t most = 2);

 private:
  device::WallPart part_ = device::WallPart::middle;
  device::Ask last_ = device::Ask::even;
  int asked_ = 0;
  bool telling_ = false, begun_ = false;
};

}  // namespace onggi::screens
