#pragma once

#include <memory>
#include <vector>

#include "kiosk/picture/view/fingers.h"
#include "kiosk/picture/view/input.h"

struct GLFWwindow;

namespace onggi::render {

/// Touches on the window through XInput2, which GLFW does not support: ten separate fingers
/// (view::Fingers). All lift when the window loses the touch screen, or when it is unplugged. Uses
/// its own connection, so that GLFW's events are unaffected.
class Touch {
 public:
  /// Nothing without X11 and XInput 2.2: then X's own emulated mouse is used.
  static std::unique_ptr<Touch> listen(GLFWwindow* window);
  ~Touch();

  std::vector<view::InputEvent> poll();
  /// True if a finger is down, or lifted so recently that its emulated mouse events may still come.
  bool active() const;
  /// Fingers that the best touch screen can follow at once; 0: there is none.
  int fingers() const;
  /// When a finger last moved, s on GLFW's clock; 0: never.
  double last_time() const { return last_time_; }

 private:
  Touch() = default;
  struct Connection;
  std::unique_ptr<Connection> connection_;
  view::Fingers fingers_;
  double last_time_ = 0;
};

}  // namespace onggi::render
