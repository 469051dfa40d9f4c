#pragma once

#include <optional>
#include <string>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// The tools beside the wheel: the bare hands, and the scene's tools, each as a small drawing with
/// its potter's name and, if there is space, what it does in everyday words. Controls
/// "throw.tool.0" (the hands) and on.
class ToolTray {
 public:
  /// In the middle of `room`, as low as possible without breaking a word. Nothing if the scene has
  /// no tool. `held`: 0 the hands, n the n-th of SceneForVisitor::tools.
  static void lay_out(Page& page, const view::Rect& room, const Desk& desk, std::size_t held);
  /// Without what the tools do; 0 if the scene has none.
  static float least_height(const Page& page, const Desk& desk, float width);
  /// Language key of the words on the button to the tray while `held` is held.
  static std::string way_in(const Desk& desk, std::size_t held);
  /// The visitors' name of `which`.
  static std::string name_of(const Desk& desk, std::size_t which);
  /// The index in "throw.tool.N"; nothing for other controls.
  static std::optional<std::size_t> of_control(const std::string& control);
};

}  // namespace onggi::screens
