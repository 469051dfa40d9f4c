#pragma once

#include <optional>
#include <string>

#include "kiosk/collection/content/language.h"
#include "kiosk/wheel/device/asked_stroke.h"

namespace onggi::rehearsal {

/// What somebody who knows the language understands of a sentence about the pot.
struct ToldDifference {
  device::WallPart part = device::WallPart::middle;
  bool wide = false;
  int by = 0;           ///< mm, or percent where no mm are known.
  bool all_so = false;  ///< So is another part, by half as much or more.
};
/// Of the first "Middle: 8 mm too narrow." in `text`. Nothing where none is said.
std::optional<ToldDifference> understand(const std::string& text,
                                         const content::Language& language);
/// What is advised of a pot that is to answer a description: "Try: Widen, Rim."
struct AdvisedStroke {
  device::WallPart part = device::WallPart::middle;
  device::Ask ask = device::Ask::even;
};
std::optional<AdvisedStroke> stroke_advised(const std::string& text,
                                            const content::Language& language);
/// What the screens call a part or a stroke.
std::string name_of_part(device::WallPart part, const content::Language& language);
std::string name_of_ask(device::Ask ask, const content::Language& language);

}  // namespace onggi::rehearsal
