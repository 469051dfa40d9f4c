#pragma once

#include <functional>

namespace onggi::render {

/// The X server may end under a running program: somebody ends it, or it dies. Xlib then ends the
/// program from within whatever call met it, and no object of it is destroyed. `last` is called
/// first, once, on the thread that met it (the main one; Xlib itself is not to be asked any more);
/// then the program ends with exit code 1, for systemd to begin both anew. An empty one takes it
/// back. Main thread.
void when_display_is_lost(std::function<void()> last);

}  // namespace onggi::render
