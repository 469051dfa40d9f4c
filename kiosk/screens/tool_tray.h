#pragma once

#include <optional>
#include <string>

#include "kiosk/screens/desk.h"
#include "kiosk/screens/page.h"

namespace onggi::screens {

/// What lies beside the wheel: the bare hands, and the scene's tools, each as a small
/// drawing with its name under it. Controls "throw.tool.0" (the hands) and on.
class ToolTray {
 public:
  /// Pixels along the pot's foot that it takes with the air about it; 0 where the scene has no
  /// tool.
  static float room(const Wheel& wheel, const TypeScale& type);
  /// `held`: 0 the hands, n the n-th of Wheel::tools.
  static void lay_out(Page& page, const Desk& desk, std::size_t held);
  /// Which one "throw.tool.N" names; nothing for other controls.
  static std::optional<std::size_t> of_control(const std::string& control);
};

}  // namespace onggi::screens
