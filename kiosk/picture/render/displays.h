#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/picture/render/outputs.h"

struct GLFWwindow;

namespace onggi::render {

/// The monitors and touch screens of an X display without a desktop: turns on what is plugged in,
/// and maps touches to the right place. Uses its own connection. Main thread.
class Displays {
 public:
  /// Nothing if this is not X11 with RandR 1.3, or if a window manager handles monitors.
  static std::unique_ptr<Displays> watch();
  ~Displays();

  /// Call once a frame, `now` in s. True if monitors or touch screens have changed, half a second
  /// after the last change of a burst. They are then on and mapped.
  bool poll(double now);
  /// Turns the monitors off (DPMS) or on. It first reads X's own state, because any touch turns
  /// them on. Does nothing if the monitors or X cannot.
  void sleep(bool on);
  /// Moves and resizes the window, pixels of the whole screen, without changing a mode.
  static void place(GLFWwindow* window, int x, int y, int width, int height);
  /// Messages about what was done, each once.
  std::vector<std::string> remarks();

 private:
  Displays() = default;
  void look();
  Outputs read() const;
  void light(const Relighting& change, const Outputs& now);
  void map_touch();

  struct Connection;
  std::unique_ptr<Connection> connection_;
  std::optional<Outputs> seen_;
  std::array<float, 9> mapped_{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< The matrix that we set last.
  double changed_at_ = 0;                                   ///< s; below 0: no change.
  bool first_ = true;
  std::vector<std::string> remarks_;
};

}  // namespace onggi::render
