#include "kiosk/render/touch.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/extensions/XInput2.h>

// From GLFW/glfw3native.h, which also wants the headers of Xrandr.
extern "C" Display* glfwGetX11Display(void);
extern "C" Window glfwGetX11Window(GLFWwindow* window);

namespace onggi::render {
namespace {

constexpr double kEchoSeconds = 0.25;  // emulated mouse events trail the touch by less

}  // namespace

struct Touch::Connection {
  Display* display = nullptr;
  int opcode = 0;
  ~Connection() {
    if (display != nullptr) XCloseDisplay(display);
  }
};

std::unique_ptr<Touch> Touch::listen(GLFWwindow* window) {
  Display* theirs = glfwGetX11Display();
  if (theirs == nullptr) return nullptr;
  auto connection = std::make_unique<Connection>();
  connection->display = XOpenDisplay(DisplayString(theirs));
  if (connection->display == nullptr) return nullptr;
  int event = 0, error = 0, major = 2, minor = 2;
  if (!XQueryExtension(connection->display, "XInputExtension", &connection->opcode, &event,
                       &error) ||
      XIQueryVersion(connection->display, &major, &minor) != Success || (major == 2 && minor < 2)) {
    return nullptr;
  }
  unsigned char mask[XIMaskLen(XI_TouchEnd)] = {};
  XISetMask(mask, XI_TouchBegin);
  XISetMask(mask, XI_TouchUpdate);
  XISetMask(mask, XI_TouchEnd);
  XIEventMask wanted{XIAllMasterDevices, sizeof mask, mask};
  // The window must be known to the server before another connection may name it.
  XSync(theirs, False);
  XISelectEvents(connection->display, glfwGetX11Window(window), &wanted, 1);
  XFlush(connection->display);
  std::unique_ptr<Touch> touch(new Touch);
  touch->connection_ = std::move(connection);
  return touch;
}

Touch::~Touch() = default;

bool Touch::active() const {
  return finger_ >= 0 || (last_time_ > 0 && glfwGetTime() - last_time_ < kEchoSeconds);
}

std::vector<view::InputEvent> Touch::poll() {
  using Kind = view::InputEvent::Kind;
  std::vector<view::InputEvent> out;
  Display* display = connection_->display;
  while (XPending(display) > 0) {
    XEvent event;
    XNextEvent(display, &event);
    XGenericEventCookie* cookie = &event.xcookie;
    if (cookie->type != GenericEvent || cookie->extension != connection_->opcode ||
        !XGetEventData(display, cookie)) {
      continue;
    }
    const auto* touch = static_cast<const XIDeviceEvent*>(cookie->data);
    const bool begins = cookie->evtype == XI_TouchBegin;
    if (begins && finger_ < 0) finger_ = touch->detail;
    if (touch->detail == finger_) {
      const bool ends = cookie->evtype == XI_TouchEnd;
      out.push_back({.kind = begins ? Kind::pointer_down
                             : ends ? Kind::pointer_up
                                    : Kind::pointer_move,
                     .x = static_cast<float>(touch->event_x),
                     .y = static_cast<float>(touch->event_y)});
      if (ends) finger_ = -1;
      last_time_ = glfwGetTime();
    }
    XFreeEventData(display, cookie);
  }
  return out;
}

}  // namespace onggi::render
