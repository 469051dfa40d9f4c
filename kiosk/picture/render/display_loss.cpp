#include "kiosk/picture/render/display_loss.h"

#include <X11/Xlib.h>

#include <cstdlib>
#include <utility>

namespace onggi::render {
namespace {

std::function<void()>& last_wish() {
  static std::function<void()> wish;
  return wish;
}

int display_is_lost(Display*) {
  if (const auto wish = std::exchange(last_wish(), {})) wish();
  // Not exit(): static objects have threads and a display that must no longer be used.
  std::_Exit(1);
}

}  // namespace

void when_display_is_lost(std::function<void()> last) {
  last_wish() = std::move(last);
  XSetIOErrorHandler(last_wish() ? display_is_lost : nullptr);
}

}  // namespace onggi::render
