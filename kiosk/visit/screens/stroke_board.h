#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/wheel/device/asked_stroke.h"

namespace onggi::screens {

/// How far a part of the pot is off, as a mean over the part: positive too wide. m of diameter, on
/// the wheel.
struct PartOff {
  device::WallPart part = device::WallPart::middle;
  double off = 0;
  bool near = true;  ///< Within what is called alike.
};
/// Of the five parts, from the foot up, `made` on the wheel, m, against the card's target. `made`
/// may be empty: then all are near. Nothing where there is no card.
std::vector<PartOff> parts_off(const ShelfCard* card, const Profile& made);

/// Strokes for a visitor who does not draw: buttons for where, and for what the hands shall do
/// there, and one that tells where the pot differs. Whatever a stroke asked for so does, it does by
/// the visitor's own two hands.
///   Controls: "throw.part.N" (WallPart), "throw.ask.N" (Ask), "throw.tell".
class StrokeBoard {
 public:
  /// This visitor has one: it comes with "Read aloud" and with "One switch".
  static bool wanted(const Desk& desk);
  static constexpr const char* kFirst = "throw.part.2";

  /// Takes one of its controls; gives the stroke that is to be made, once one was asked for.
  std::optional<device::Ask> press(const std::string& control);
  device::WallPart part() const { return part_; }
  /// A stroke was asked for.
  bool begun() const { return begun_; }
  /// How often it was asked where the pot differs.
  int asked() const { return asked_; }

  /// From the foot of `column` up; before everything else of the page the sentence: what is being
  /// done, or how the pot differs where that was asked, or else `hint`. `way`: to the drawer.
  void lay_out(Column& column, const Desk& desk, const std::vector<Button>& ways,
               const std::vector<PartOff>& parts, bool working, const std::string& hint) const;
  /// Of a pot that is to answer a description, what would bring it nearer: the stroke and its part
  /// by the names of their buttons. "" where nothing is described or known.
  static std::string advice(const Desk& desk);
  /// The whole pot in words, worst part first: at most `most` sentences. One that is to answer a
  /// description: what it measures, and advice().
  static std::vector<std::string> told(const Desk& desk, const std::vector<PartOff>& parts,
                                       std::size_t most = 2);

 private:
  device::WallPart part_ = device::WallPart::middle;
  device::Ask last_ = device::Ask::even;
  int asked_ = 0;
  bool telling_ = false, begun_ = false;
};

}  // namespace onggi::screens
