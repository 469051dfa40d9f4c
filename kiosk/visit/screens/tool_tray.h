#pragma once

#include <optional>
#include <string>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// What lies to hand beside the wheel: the bare hands, and the scene's tools, each as a small
/// drawing with its name beside it. Controls "throw.tool.0" (the hands) and on.
class ToolTray {
 public:
  /// As low from the top of `column` as can be with no word of a name broken; nothing where the
  /// scene has no tool. `held`: 0 the hands, n the n-th of Wheel::tools.
  static void lay_out(Column& column, const Desk& desk, std::size_t held);
  /// What `which` is called, for people.
  static std::string name_of(const Desk& desk, std::size_t which);
  /// Which one "throw.tool.N" names; nothing for other controls.
  static std::optional<std::size_t> of_control(const std::string& control);
};

}  // namespace onggi::screens
