#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/picture/view/input.h"

struct GLFWwindow;

namespace onggi::render {

class Displays;
class Touch;

/// The window with its GL context, and all of its input.
class Window {
 public:
  static Result<std::unique_ptr<Window>> create(const WindowOptions& options);
  ~Window();

  int width() const { return width_; }
  int height() const { return height_; }
  bool visible() const { return visible_; }
  std::vector<view::InputEvent> poll();
  int fingers() const;  ///< Same as Touch's.
  void swap();
  /// Call once a frame: turns the monitor off or on; does nothing in a window.
  void sleep(bool on);
  /// Messages about monitors and touch screens for staff, each once.
  std::vector<std::string> remarks();

 private:
  Window() = default;
  void listen();
  void push(view::InputEvent event);
  void pointer(view::InputEvent::Kind kind, double x, double y);
  void key(int key, int action, int mods);
  void mind_monitor(double now);
  void mind_cursor(double now);

  GLFWwindow* window_ = nullptr;
  std::unique_ptr<Touch> touch_;
  std::unique_ptr<Displays> displays_;  ///< Only for a kiosk that fills the screen.
  std::vector<view::InputEvent> events_;
  int width_ = 0, height_ = 0;
  bool visible_ = true, full_screen_ = false, cursor_shown_ = true, pressed_ = false;
  bool monitor_lost_ = false, asleep_ = false;
  double put_to_sleep_ = 0;  // s: when the monitor was turned off or on
  double looked_at_ = 0;     // s; last look at the monitor
  double cursor_moved_ = 0;  // s, GLFW's clock
  float x_ = 0, y_ = 0;
};

}  // namespace onggi::render
