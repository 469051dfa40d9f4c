#pragma once

#include <functional>

namespace onggi::render {

/// Handles the end of the X server under a running program. Xlib then ends the program inside the
/// call that noticed it, without destroying objects. `last` is called first, once, on that thread
/// (the main one; Xlib must not be used any more). Then the program ends with exit code 1, and
/// systemd restarts both. An empty function removes the handler. Main thread.
void when_display_is_lost(std::function<void()> last);

}  // namespace onggi::render
