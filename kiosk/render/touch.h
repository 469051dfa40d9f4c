#pragma once

#include <memory>
#include <vector>

#include "kiosk/view/input.h"

struct GLFWwindow;

namespace onggi::render {

/// Touches on the window by XInput2, which GLFW does not know. The first finger down is the
/// pointer; others are let be until it lifts (a visitor leaning a hand on the screen does not
/// disturb the pot). On a connection of its own, so that GLFW's events stay GLFW's.
class Touch {
 public:
  /// Nothing where the display is not X11 or has no XInput 2.2: then X's own emulated mouse serves.
  static std::unique_ptr<Touch> listen(GLFWwindow* window);
  ~Touch();

  std::vector<view::InputEvent> poll();
  /// A finger is down, or lifted so recently that its emulated mouse events may still come.
  bool active() const;
  /// When a finger last moved, s on GLFW's clock; 0 never.
  double last_time() const { return last_time_; }

 private:
  Touch() = default;
  struct Connection;
  std::unique_ptr<Connection> connection_;
  int finger_ = -1;
  double last_time_ = 0;
};

}  // namespace onggi::render
