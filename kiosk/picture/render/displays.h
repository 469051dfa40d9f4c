#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/picture/render/outputs.h"

struct GLFWwindow;

namespace onggi::render {

/// The monitors and touch screens of an X display that has no desktop to look after them: what is
/// plugged in is lit, and a finger falls where it touches. On a connection of its own. Main thread.
class Displays {
 public:
  /// Nothing where this is not X11 with RandR 1.3, or where a window manager looks after it.
  static std::unique_ptr<Displays> watch();
  ~Displays();

  /// Once a frame, `now` in s. True when monitors or touch screens have changed; by then they are
  /// lit and mapped, half a second after the last of a burst of changes.
  bool poll(double now);
  /// Lets the monitors sleep (DPMS), or wakes them; what X has come to meanwhile is read back
  /// first, for any touch wakes them. Nothing where they or X cannot.
  void sleep(bool on);
  /// Moves the window and gives it a size, pixels of the whole screen, and changes no mode.
  static void place(GLFWwindow* window, int x, int y, int width, int height);
  /// What was done, a line each, once.
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
  std::array<float, 9> mapped_{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< As we last set it.
  double changed_at_ = 0;                                   ///< s; below 0: nothing has.
  bool first_ = true;
  std::vector<std::string> remarks_;
};

}  // namespace onggi::render
