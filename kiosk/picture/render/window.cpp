#include "kiosk/picture/render/window.h"

#include <epoxy/gl.h>
// epoxy provides GL.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

#include "kiosk/picture/render/displays.h"
#include "kiosk/picture/render/touch.h"

namespace onggi::render {
namespace {

constexpr double kStillSeconds = 3.0;  // s after which the cursor hides
constexpr double kLookAgain = 2.0;     // s between checks for changes that no event reports
using view::InputEvent;
using view::Key;

std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

Key key_of(int key, bool shift) {
  switch (key) {
    case GLFW_KEY_UP:
      return Key::up;
    case GLFW_KEY_DOWN:
      return Key::down;
    case GLFW_KEY_LEFT:
      return Key::left;
    case GLFW_KEY_RIGHT:
      return Key::right;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
    case GLFW_KEY_SPACE:
      return Key::enter;
    case GLFW_KEY_ESCAPE:
    case GLFW_KEY_BACKSPACE:
      return Key::back;
    case GLFW_KEY_F1:
    case GLFW_KEY_H:
      return Key::help;
    case GLFW_KEY_PAGE_UP:
    case GLFW_KEY_PERIOD:
      return Key::depth_in;
    case GLFW_KEY_PAGE_DOWN:
    case GLFW_KEY_COMMA:
      return Key::depth_out;
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
      return Key::faster;
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
      return Key::slower;
    case GLFW_KEY_S:
      return Key::side;
    case GLFW_KEY_W:
      return Key::water;
    case GLFW_KEY_R:
      return Key::renew;
    case GLFW_KEY_Z:
      return Key::restore;
    case GLFW_KEY_C:
      return Key::cut;
    case GLFW_KEY_L:
      return Key::language;
    case GLFW_KEY_A:
      return Key::comfort;
    case GLFW_KEY_TAB:
      return shift ? Key::previous : Key::next;
    case GLFW_KEY_V:
      return Key::tell;
    default:
      return Key::other;
  }
}

tl::unexpected<Problem> no_display(const std::string& reason) {
  const auto given = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  if (given("DISPLAY"))
    return problem("display", "No window can be opened: " + reason + ".",
                   std::string("Check that an X server runs on the display that DISPLAY names, ") +
                       std::getenv("DISPLAY") + ", or start Onggi under xvfb-run.",
                   1);
  if (given("WAYLAND_DISPLAY"))
    return problem(
        "display",
        "This desktop is Wayland without Xwayland (DISPLAY is empty), and Onggi needs X.",
        "Install xwayland and log in again, or start Onggi from an X session.", 1);
  return problem("display", "No window can be opened: there is no X display (DISPLAY is empty).",
                 "Start Onggi from a desktop, or under xvfb-run.", 1);
}

void ask_for_opengl() {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
}

// For small boards: the Raspberry Pi has OpenGL 3.1 and OpenGL ES 3.1.
void ask_for_opengl_es() {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_ANY_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_FALSE);
}

// Graphics drivers keep tables and threads for the life of the process, and their exit handlers run
// after GLFW would have unloaded them (which also confuses leak checkers). So keep them loaded.
// Mesa up to 24.1 has one file a driver, *_dri.so; from 24.2 a single one, libgallium-*.so.
void keep_drivers_loaded() {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const auto path = line.find('/');
    if (path == std::string::npos || (line.find("_dri.so", path) == std::string::npos &&
                                      line.find("/libgallium-", path) == std::string::npos))
      continue;
    dlopen(line.c_str() + path, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
  }
}

Window* self(GLFWwindow* window) { return static_cast<Window*>(glfwGetWindowUserPointer(window)); }

}  // namespace

Result<std::unique_ptr<Window>> Window::create(const WindowOptions& options) {
#ifdef GLFW_PLATFORM
  // From version 3.4 GLFW uses Wayland if a desktop offers it. Touches, outputs and turning the
  // monitor off need X (touch.h, displays.h), which such a desktop also offers, through Xwayland.
  glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
  if (glfwInit() != GLFW_TRUE) return no_display(last_error());
  const bool full = options.width == 0 && options.height == 0;
  GLFWmonitor* monitor = full ? glfwGetPrimaryMonitor() : nullptr;
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  const int width = mode != nullptr ? mode->width : (full ? 1280 : options.width);
  const int height = mode != nullptr ? mode->height : (full ? 720 : options.height);

  ask_for_opengl();
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
  glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  // A hidden window cannot be full screen, because that would show it.
  GLFWmonitor* on = options.visible ? monitor : nullptr;
  const auto open = [&] {
    return glfwCreateWindow(width, height, options.title.c_str(), on, nullptr);
  };
  GLFWwindow* made = open();
  const std::string why_not = made == nullptr ? last_error() : "";
  if (made == nullptr) {
    ask_for_opengl_es();
    made = open();
  }
  if (made == nullptr) {
    auto why = problem("display",
                       "A window with OpenGL 3.3 core cannot be opened (" + why_not +
                           "), nor one with OpenGL ES 3.1 (" + last_error() + ").",
                       "Install the graphics driver (Debian: libgl1-mesa-dri), or run with "
                       "LIBGL_ALWAYS_SOFTWARE=1.",
                       1);
    glfwTerminate();
    return why;
  }
  std::unique_ptr<Window> window(new Window);
  window->window_ = made;
  window->visible_ = options.visible;
  window->full_screen_ = full;
  glfwMakeContextCurrent(made);
  keep_drivers_loaded();
  glfwSwapInterval(0);  // Renderer::present paces the frames
  glfwGetFramebufferSize(made, &window->width_, &window->height_);
  if (!options.visible) {
    window->width_ = width;
    window->height_ = height;
  }
  window->listen();
  return window;
}

Window::~Window() {
  touch_.reset();
  displays_.reset();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::listen() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int width, int height) {
    if (width < 1 || height < 1) return;
    self(w)->width_ = width;
    self(w)->height_ = height;
    self(w)->push({.kind = InputEvent::Kind::resize,
                   .x = static_cast<float>(width),
                   .y = static_cast<float>(height)});
  });
  glfwSetWindowCloseCallback(
      window_, [](GLFWwindow* w) { self(w)->push({.kind = InputEvent::Kind::close}); });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    self(w)->pointer(InputEvent::Kind::pointer_move, x, y);
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    double x = 0, y = 0;
    glfwGetCursorPos(w, &x, &y);
    self(w)->pointer(
        action == GLFW_PRESS ? InputEvent::Kind::pointer_down : InputEvent::Kind::pointer_up, x, y);
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double notches) {
    self(w)->push({.kind = InputEvent::Kind::scroll,
                   .x = self(w)->x_,
                   .y = self(w)->y_,
                   .scroll = static_cast<float>(notches)});
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int mods) {
    self(w)->key(key, action, mods);
  });
  // If a monitor is lost, GLFW silently changes to a small window. Return to full screen when there
  // is a monitor again. No monitor at all is a valid state: keep running.
  glfwSetMonitorCallback([](GLFWmonitor*, int) {
    if (GLFWwindow* w = glfwGetCurrentContext()) self(w)->monitor_lost_ = true;
  });
  touch_ = Touch::listen(window_);
  if (full_screen_ && visible_) displays_ = Displays::watch();
}

void Window::push(InputEvent event) { events_.push_back(event); }

void Window::pointer(InputEvent::Kind kind, double x, double y) {
  // A touch also arrives as an emulated mouse; the touch itself was already handled.
  if (touch_ != nullptr && touch_->active()) return;
  // Convert window coordinates to framebuffer pixels (they differ on scaled displays).
  int w = 0, h = 0;
  glfwGetWindowSize(window_, &w, &h);
  x_ = static_cast<float>(x * width_ / std::max(w, 1));
  y_ = static_cast<float>(y * height_ / std::max(h, 1));
  if (kind == InputEvent::Kind::pointer_down) pressed_ = true;
  if (kind == InputEvent::Kind::pointer_up) pressed_ = false;
  cursor_moved_ = glfwGetTime();
  push({.kind = kind, .x = x_, .y = y_});
}

void Window::key(int key, int action, int mods) {
  const Key named = key_of(key, (mods & GLFW_MOD_SHIFT) != 0);
  push({.kind = action == GLFW_RELEASE ? InputEvent::Kind::key_up : InputEvent::Kind::key_down,
        .key = named,
        .repeat = action == GLFW_REPEAT});
}

void Window::mind_monitor(double now) {
  if (!full_screen_ || !visible_) return;
  const bool changed = displays_ != nullptr && displays_->poll(now);
  if (!changed && !monitor_lost_ && now - looked_at_ < kLookAgain) return;
  looked_at_ = now;
  GLFWmonitor* monitor = glfwGetWindowMonitor(window_);
  const bool lost = monitor == nullptr;
  if (lost) monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) return;
  monitor_lost_ = false;
  if (lost)
    return glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height,
                                mode->refreshRate);
  // GLFW does not report a new mode of the same monitor, and without a window manager the window
  // would keep the old screen's size.
  int x = 0, y = 0, at_x = 0, at_y = 0, w = 0, h = 0;
  glfwGetMonitorPos(monitor, &x, &y);
  glfwGetWindowPos(window_, &at_x, &at_y);
  glfwGetWindowSize(window_, &w, &h);
  const bool fills = at_x == x && at_y == y && w == mode->width && h == mode->height;
  if (!fills && displays_ != nullptr) Displays::place(window_, x, y, mode->width, mode->height);
}

void Window::sleep(bool on) {
  const double now = glfwGetTime();
  if (displays_ == nullptr || (on == asleep_ && now - put_to_sleep_ < kLookAgain)) return;
  asleep_ = on;
  put_to_sleep_ = now;
  displays_->sleep(on);
}

int Window::fingers() const { return touch_ != nullptr ? touch_->fingers() : 0; }

std::vector<std::string> Window::remarks() {
  return displays_ != nullptr ? displays_->remarks() : std::vector<std::string>();
}

void Window::mind_cursor(double now) {
  if (!visible_) return;
  const bool touched = touch_ != nullptr && touch_->last_time() > cursor_moved_;
  const bool show = !touched && (pressed_ || now - cursor_moved_ < kStillSeconds);
  if (show == cursor_shown_) return;
  cursor_shown_ = show;
  glfwSetInputMode(window_, GLFW_CURSOR, show ? GLFW_CURSOR_NORMAL : GLFW_CURSOR_HIDDEN);
}

std::vector<InputEvent> Window::poll() {
  if (touch_ != nullptr) {
    for (const InputEvent& event : touch_->poll()) push(event);
  }
  glfwPollEvents();
  const double now = glfwGetTime();
  mind_monitor(now);
  mind_cursor(now);
  return std::exchange(events_, {});
}

void Window::swap() { glfwSwapBuffers(window_); }

}  // namespace onggi::render
