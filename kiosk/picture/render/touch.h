#pragma once

#include <memory>
#include <vector>

#include "kiosk/picture/view/fingers.h"
#include "kiosk/picture/view/input.h"

struct GLFWwindow;

namespace onggi::render {

/// Touches on the window by XInput2, which GLFW does not know: ten fingers, told apart
/// (view::Fingers). All lift when the window loses the glass or the glass the machine. On a
/// connection of its own, so that GLFW's events stay GLFW's.
class Touch {
 public:
  /// Nothing where the display is not X11 or has no XInput 2.2: then X's own emulated mouse serves.
  static std::unique_ptr<Touch> listen(GLFWwindow* window);
  ~Touch();

  std::vector<view::InputEvent> poll();
  /// A finger is down, or lifted so recently that its emulated mouse events may still come.
  bool active() const;
  /// How many fingers the glass tells apart at once, of the one that tells most; 0: there is none.
  int fingers() const;
  /// When a finger last moved, s on GLFW's clock; 0 never.
  double last_time() const { return last_time_; }

 private:
  Touch() = default;
  struct Connection;
  std::unique_ptr<Connection> connection_;
  view::Fingers fingers_;
  double last_time_ = 0;
};

}  // namespace onggi::render
