#include "kiosk/picture/render/displays.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/Xatom.h>
#include <X11/extensions/XInput2.h>
#include <X11/extensions/Xrandr.h>
#include <X11/extensions/dpms.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

// From GLFW/glfw3native.h.
extern "C" Display* glfwGetX11Display(void);
extern "C" Window glfwGetX11Window(GLFWwindow* window);

namespace onggi::render {

namespace {

constexpr double kBurst = 0.5;  // s: changes this close are handled together
constexpr std::array<float, 9> kWhole{1, 0, 0, 0, 1, 0, 0, 0, 1};

/// An X object may have been unplugged meanwhile, and Xlib would end the program because of it.
/// This class ignores that error.
class IgnoredXErrors {
 public:
  explicit IgnoredXErrors(Display* display) : display_(display) {
    XSync(display_, False);
    before_ = XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
  }
  ~IgnoredXErrors() {
    XSync(display_, False);
    XSetErrorHandler(before_);
  }
  IgnoredXErrors(const IgnoredXErrors&) = delete;
  IgnoredXErrors& operator=(const IgnoredXErrors&) = delete;

 private:
  Display* display_;
  XErrorHandler before_;
};

bool has_window_manager(Display* display) {
  const Atom check = XInternAtom(display, "_NET_SUPPORTING_WM_CHECK", True);
  if (check == 0) return false;
  Atom type = 0;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char* data = nullptr;
  const int good = XGetWindowProperty(display, DefaultRootWindow(display), check, 0, 1, False,
                                      XA_WINDOW, &type, &format, &count, &left, &data);
  if (data != nullptr) XFree(data);
  return good == Success && count == 1;
}

/// FNV-1a over the EDID.
std::uint64_t monitor_of(Display* display, RROutput output, Atom edid) {
  if (edid == 0) return 0;
  Atom type = 0;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char* data = nullptr;
  const int good = XRRGetOutputProperty(display, output, edid, 0, 128, False, False,
                                        AnyPropertyType, &type, &format, &count, &left, &data);
  std::uint64_t hash = 0;
  if (good == Success && format == 8 && count > 0) {
    hash = 0xcbf29ce484222325u;
    for (unsigned long n = 0; n < count; ++n) hash = (hash ^ data[n]) * 0x100000001b3u;
  }
  if (data != nullptr) XFree(data);
  return hash;
}

Output::Turned turned_by(Rotation rotation) {
  if ((rotation & RR_Rotate_90) != 0) return Output::Turned::left;
  if ((rotation & RR_Rotate_180) != 0) return Output::Turned::upside_down;
  if ((rotation & RR_Rotate_270) != 0) return Output::Turned::right;
  return Output::Turned::upright;
}

bool is_touch_screen(const XIDeviceInfo& device) {
  for (int n = 0; n < device.num_classes; ++n) {
    if (device.classes[n]->type != XITouchClass) continue;
    if (reinterpret_cast<const XITouchClassInfo*>(device.classes[n])->mode == XIDirectTouch)
      return true;
  }
  return false;
}

}  // namespace

struct Displays::Connection {
  Display* display = nullptr;
  int input = 0;       ///< XInput's opcode.
  int randr_base = 0;  ///< RandR's first event.
  Atom edid = 0, matrix = 0, real = 0;
  ~Connection() {
    if (display != nullptr) XCloseDisplay(display);
  }
};

std::unique_ptr<Displays> Displays::watch() {
  Display* theirs = glfwGetX11Display();
  if (theirs == nullptr) return nullptr;
  auto connection = std::make_unique<Connection>();
  Connection& c = *connection;
  c.display = XOpenDisplay(DisplayString(theirs));
  if (c.display == nullptr || has_window_manager(c.display)) return nullptr;
  int event = 0, error = 0, major = 0, minor = 0;
  if (!XRRQueryExtension(c.display, &c.randr_base, &error) ||
      !XRRQueryVersion(c.display, &major, &minor) || major * 100 + minor < 103)
    return nullptr;
  XRRSelectInput(c.display, DefaultRootWindow(c.display),
                 RRScreenChangeNotifyMask | RRCrtcChangeNotifyMask | RROutputChangeNotifyMask);
  major = minor = 2;
  if (XQueryExtension(c.display, "XInputExtension", &c.input, &event, &error) &&
      XIQueryVersion(c.display, &major, &minor) == Success) {
    unsigned char mask[XIMaskLen(XI_LASTEVENT)] = {};
    XISetMask(mask, XI_HierarchyChanged);
    XIEventMask wanted{XIAllDevices, sizeof mask, mask};
    XISelectEvents(c.display, DefaultRootWindow(c.display), &wanted, 1);
  } else {
    c.input = 0;
  }
  c.edid = XInternAtom(c.display, RR_PROPERTY_RANDR_EDID, False);
  c.matrix = XInternAtom(c.display, "Coordinate Transformation Matrix", False);
  c.real = XInternAtom(c.display, "FLOAT", False);
  XFlush(c.display);
  std::unique_ptr<Displays> displays(new Displays);
  displays->connection_ = std::move(connection);
  return displays;
}

Displays::~Displays() = default;

bool Displays::poll(double now) {
  Display* display = connection_->display;
  while (XPending(display) > 0) {
    XEvent event;
    XNextEvent(display, &event);
    // Xlib keeps its own copy of a screen's size.
    if (event.type == connection_->randr_base + RRScreenChangeNotify)
      XRRUpdateConfiguration(&event);
    changed_at_ = now;
  }
  if (changed_at_ < 0 || (!first_ && now - changed_at_ < kBurst)) return false;
  changed_at_ = -1;
  first_ = false;
  look();
  return true;
}

void Displays::sleep(bool on) {
  Display* display = connection_->display;
  int event = 0, error = 0;
  if (!DPMSQueryExtension(display, &event, &error) || !DPMSCapable(display)) return;
  CARD16 level = 0;
  BOOL enabled = False;
  if (!DPMSInfo(display, &level, &enabled)) return;
  const CARD16 wanted = on ? DPMSModeOff : DPMSModeOn;
  if (level == wanted) return;
  if (!enabled) DPMSEnable(display);
  DPMSForceLevel(display, wanted);
  XFlush(display);
}

std::vector<std::string> Displays::remarks() { return std::exchange(remarks_, {}); }

Outputs Displays::read() const {
  const Connection& c = *connection_;
  const Window root = DefaultRootWindow(c.display);
  Outputs outputs;
  outputs.primary = XRRGetOutputPrimary(c.display, root);
  XRRScreenResources* all = XRRGetScreenResourcesCurrent(c.display, root);
  if (all == nullptr) return outputs;
  for (int n = 0; n < all->noutput; ++n) {
    XRROutputInfo* info = XRRGetOutputInfo(c.display, all, all->outputs[n]);
    if (info == nullptr) continue;
    Output output;
    output.id = all->outputs[n];
    output.connected = info->connection == RR_Connected;
    if (output.connected) output.monitor = monitor_of(c.display, all->outputs[n], c.edid);
    // RandR lists the preferred modes first.
    output.modes.assign(info->modes, info->modes + info->nmode);
    if (info->crtc != 0) {
      if (XRRCrtcInfo* crtc = XRRGetCrtcInfo(c.display, all, info->crtc)) {
        output.mode = crtc->mode;
        output.x = crtc->x;
        output.y = crtc->y;
        output.width = static_cast<int>(crtc->width);
        output.height = static_cast<int>(crtc->height);
        output.turned = turned_by(crtc->rotation);
        XRRFreeCrtcInfo(crtc);
      }
    }
    outputs.all.push_back(std::move(output));
    XRRFreeOutputInfo(info);
  }
  XRRFreeScreenResources(all);
  XWindowAttributes whole{};
  XGetWindowAttributes(c.display, root, &whole);
  outputs.width = whole.width;
  outputs.height = whole.height;
  return outputs;
}

void Displays::look() {
  const IgnoredXErrors ignored(connection_->display);
  Outputs now = read();
  const Relighting change = relight(seen_, now);
  if (change.light != 0) {
    light(change, now);
    now = read();
    if (const Output* on = now.shown_on())
      remarks_.push_back("A monitor was plugged in: it shows " + std::to_string(on->width) + " x " +
                         std::to_string(on->height) + ".");
  }
  seen_ = std::move(now);
  map_touch();
}

void Displays::light(const Relighting& change, const Outputs& now) {
  const Connection& c = *connection_;
  const Window root = DefaultRootWindow(c.display);
  XRRScreenResources* all = XRRGetScreenResourcesCurrent(c.display, root);
  if (all == nullptr) return;
  const auto dark = [&](std::uint64_t id) {
    XRROutputInfo* info = XRRGetOutputInfo(c.display, all, id);
    if (info == nullptr) return;
    if (info->crtc != 0)
      XRRSetCrtcConfig(c.display, all, info->crtc, CurrentTime, 0, 0, 0, RR_Rotate_0, nullptr, 0);
    XRRFreeOutputInfo(info);
  };
  int width = 0, height = 0;
  for (int n = 0; n < all->nmode; ++n) {
    if (all->modes[n].id != change.mode) continue;
    width = static_cast<int>(all->modes[n].width);
    height = static_cast<int>(all->modes[n].height);
  }
  const auto goes = [&](std::uint64_t id) {
    return id == change.light ||
           std::find(change.darken.begin(), change.darken.end(), id) != change.darken.end();
  };
  for (const Output& other : now.all) {
    if (other.mode == 0 || goes(other.id)) continue;
    width = std::max(width, other.x + other.width);
    height = std::max(height, other.y + other.height);
  }
  XRROutputInfo* info = XRRGetOutputInfo(c.display, all, change.light);
  if (info != nullptr) {
    XGrabServer(c.display);  // so that nobody draws on a half-configured screen
    for (const std::uint64_t id : change.darken) dark(id);
    dark(change.light);
    constexpr double kMmPerPixel = 25.4 / 96.0;
    XRRSetScreenSize(c.display, root, width, height,
                     static_cast<int>(std::lround(width * kMmPerPixel)),
                     static_cast<int>(std::lround(height * kMmPerPixel)));
    RRCrtc crtc = info->crtc;
    for (int n = 0; crtc == 0 && n < info->ncrtc; ++n) {
      XRRCrtcInfo* at = XRRGetCrtcInfo(c.display, all, info->crtcs[n]);
      if (at == nullptr) continue;
      if (at->mode == 0) crtc = info->crtcs[n];
      XRRFreeCrtcInfo(at);
    }
    RROutput output = change.light;
    if (crtc != 0)
      XRRSetCrtcConfig(c.display, all, crtc, CurrentTime, 0, 0, change.mode, RR_Rotate_0, &output,
                       1);
    XUngrabServer(c.display);
    XRRFreeOutputInfo(info);
  }
  XRRFreeScreenResources(all);
  XSync(c.display, False);
}

void Displays::map_touch() {
  const Connection& c = *connection_;
  const Output* on = seen_->shown_on();
  if (c.input == 0 || on == nullptr || on->mode == 0) return;
  const std::array<float, 9> map = touch_map(*seen_, *on);
  int count = 0;
  XIDeviceInfo* devices = XIQueryDevice(c.display, XIAllDevices, &count);
  if (devices == nullptr) return;
  int turned = 0;
  for (int n = 0; n < count; ++n) {
    if (!is_touch_screen(devices[n])) continue;
    Atom type = 0;
    int format = 0;
    unsigned long items = 0, left = 0;
    unsigned char* data = nullptr;
    XIGetProperty(c.display, devices[n].deviceid, c.matrix, 0, 9, False, c.real, &type, &format,
                  &items, &left, &data);
    std::array<float, 9> is{};
    const bool read = data != nullptr && format == 32 && items == 9;
    if (read) std::memcpy(is.data(), data, sizeof is);
    if (data != nullptr) XFree(data);
    // A matrix that the museum has set stays: staff know how the touch screen is mounted.
    if (!read || is == map || (is != kWhole && is != mapped_)) continue;
    auto wanted = map;
    XIChangeProperty(c.display, devices[n].deviceid, c.matrix, c.real, 32, PropModeReplace,
                     reinterpret_cast<unsigned char*>(wanted.data()), 9);
    ++turned;
  }
  XIFreeDeviceInfo(devices);
  mapped_ = map;
  if (turned > 0) remarks_.push_back("The touch screen was mapped to its monitor.");
}

void Displays::place(GLFWwindow* window, int x, int y, int width, int height) {
  XMoveResizeWindow(glfwGetX11Display(), glfwGetX11Window(window), x, y,
                    static_cast<unsigned>(width), static_cast<unsigned>(height));
  XFlush(glfwGetX11Display());
}

}  // namespace onggi::render
