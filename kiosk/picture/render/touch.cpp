#include "kiosk/picture/render/touch.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/extensions/XInput2.h>

#include <algorithm>

// From GLFW/glfw3native.h, which also wants the headers of Xrandr.
extern "C" Display* glfwGetX11Display(void);
extern "C" Window glfwGetX11Window(GLFWwindow* window);

namespace onggi::render {
namespace {

constexpr double kEchoSeconds = 0.25;  // s: emulated mouse events follow the touch within this time

/// A device was unplugged or turned off, so its fingers can no longer be followed.
bool glass_left(const XGenericEventCookie& cookie) {
  if (cookie.evtype != XI_HierarchyChanged) return false;
  const auto* change = static_cast<const XIHierarchyEvent*>(cookie.data);
  return (change->flags & (XISlaveRemoved | XIDeviceDisabled)) != 0;
}

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
  unsigned char mask[XIMaskLen(XI_LASTEVENT)] = {};
  XISetMask(mask, XI_TouchBegin);
  XISetMask(mask, XI_TouchUpdate);
  XISetMask(mask, XI_TouchEnd);
  XISetMask(mask, XI_FocusOut);
  XIEventMask wanted{XIAllMasterDevices, sizeof mask, mask};
  // The server must know the window before another connection may name it.
  XSync(theirs, False);
  XISelectEvents(connection->display, glfwGetX11Window(window), &wanted, 1);
  unsigned char devices[XIMaskLen(XI_LASTEVENT)] = {};
  XISetMask(devices, XI_HierarchyChanged);
  XIEventMask comings{XIAllDevices, sizeof devices, devices};
  XISelectEvents(connection->display, DefaultRootWindow(connection->display), &comings, 1);
  XFlush(connection->display);
  std::unique_ptr<Touch> touch(new Touch);
  touch->connection_ = std::move(connection);
  return touch;
}

Touch::~Touch() = default;

bool Touch::active() const {
  return fingers_.any() || (last_time_ > 0 && glfwGetTime() - last_time_ < kEchoSeconds);
}

int Touch::fingers() const {
  int count = 0, most = 0;
  XIDeviceInfo* const all = XIQueryDevice(connection_->display, XIAllDevices, &count);
  for (int n = 0; all != nullptr && n < count; ++n) {
    if (all[n].use != XISlavePointer && all[n].use != XIFloatingSlave) continue;
    for (int k = 0; k < all[n].num_classes; ++k) {
      if (all[n].classes[k]->type != XITouchClass) continue;
      const auto* glass = reinterpret_cast<const XITouchClassInfo*>(all[n].classes[k]);
      if (glass->mode != XIDirectTouch) continue;  // a touch pad is a mouse
      // 0 means that there is no limit.
      most = std::max(most, glass->num_touches == 0 ? view::Fingers::kMost : glass->num_touches);
    }
  }
  if (all != nullptr) XIFreeDeviceInfo(all);
  return most;
}

std::vector<view::InputEvent> Touch::poll() {
  std::vector<view::InputEvent> out;
  Display* display = connection_->display;
  const double now = glfwGetTime();
  while (XPending(display) > 0) {
    XEvent event;
    XNextEvent(display, &event);
    XGenericEventCookie* cookie = &event.xcookie;
    if (cookie->type != GenericEvent || cookie->extension != connection_->opcode ||
        !XGetEventData(display, cookie)) {
      continue;
    }
    if (cookie->evtype == XI_FocusOut || glass_left(*cookie)) {
      fingers_.let_go(out);
    } else if (cookie->evtype >= XI_TouchBegin && cookie->evtype <= XI_TouchEnd) {
      const auto* touch = static_cast<const XIDeviceEvent*>(cookie->data);
      const auto id = static_cast<std::uint32_t>(touch->detail);
      const auto x = static_cast<float>(touch->event_x), y = static_cast<float>(touch->event_y);
      if (cookie->evtype == XI_TouchBegin) fingers_.down(id, x, y, now, out);
      if (cookie->evtype == XI_TouchUpdate) fingers_.move(id, x, y, now, out);
      if (cookie->evtype == XI_TouchEnd) fingers_.up(id, x, y, now, out);
      last_time_ = now;
    }
    XFreeEventData(display, cookie);
  }
  fingers_.look_after(now, out);
  return out;
}

}  // namespace onggi::render
