#pragma once

#include <optional>
#include <string>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// The tools beside the wheel: the bare hands, and the scene's tools, each as a small drawing with
/// its name. Controls "throw.tool.0" (the hands) and on.
class ToolTray {
 public:
  /// As low as possible from the top of `column` without breaking a word. Nothing if the scene has
  /// no tool. `held`: 0 the hands, n the n-th of SceneForVisitor::tools.
  static void lay_out(Column& column, const Desk& desk, std::size_t held);
  /// The visitors' name of `which`.
  static std::string name_of(const Desk& desk, std::size_t which);
  /// The index in "throw.tool.N"; nothing for other controls.
  static std::optional<std::size_t> of_control(const std::string& control);
};

}  // namespace onggi::screens
