#pragma once

#include <optional>
#include <string>

#include "kiosk/collection/content/language.h"
#include "kiosk/wheel/device/asked_stroke.h"

namespace onggi::rehearsal {

/// The facts that a listener understands from a sentence about the pot.
struct ToldDifference {
  device::WallPart part = device::WallPart::middle;
  bool wide = false;
  int by = 0;           ///< mm, or percent if no mm are known.
  bool all_so = false;  ///< Another part is off in the same way, by half as much or more.
};
/// From the first "Middle: 8 mm too narrow." in `text`. Nothing if there is none.
std::optional<ToldDifference> understand(const std::string& text,
                                         const content::Language& language);
/// The advice for a pot that answers a description: "Try: Widen, Rim."
struct AdvisedStroke {
  device::WallPart part = device::WallPart::middle;
  device::Ask ask = device::Ask::even;
};
std::optional<AdvisedStroke> stroke_advised(const std::string& text,
                                            const content::Language& language);
/// The screens' words for a part or a stroke.
std::string name_of_part(device::WallPart part, const content::Language& language);
std::string name_of_ask(device::Ask ask, const content::Language& language);

}  // namespace onggi::rehearsal
