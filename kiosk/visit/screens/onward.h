#pragma once

#include <optional>
#include <string>

#include "kiosk/visit/screens/desk.h"

namespace onggi::screens {

/// What the result offers by name beside the same vessel: after four or five stars the next harder
/// vessel, or the next mission; after one or two the next easier vessel.
struct Onward {
  LabelAt of;       ///< The label that it leads to.
  std::string key;  ///< Language key of the button, with {what}.
  std::string words(const Desk& desk) const;
};

std::optional<Onward> onward_from(const Desk& desk);

}  // namespace onggi::screens
