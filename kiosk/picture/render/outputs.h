#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace onggi::render {

/// A connector of the graphics card and its monitor, as reported by RandR.
struct Output {
  enum class Turned : std::uint8_t { upright, left, upside_down, right };
  std::uint64_t id = 0;
  bool connected = false;
  std::uint64_t monitor = 0;           ///< A hash of its EDID; 0: none.
  std::vector<std::uint64_t> modes{};  ///< The modes that it supports, its preferred one first.
  std::uint64_t mode = 0;              ///< The current mode; 0: it is off.
  int x = 0, y = 0, width = 0, height = 0;  ///< Place on the whole screen, pixels.
  Turned turned = Turned::upright;
  friend bool operator==(const Output&, const Output&) = default;
};

/// All connectors, and the X screen that they form.
struct Outputs {
  int width = 0, height = 0;  ///< Pixels.
  std::uint64_t primary = 0;  ///< An Output::id; 0: none was named.
  std::vector<Output> all{};

  /// The output that shows the kiosk: the primary one, else the first that is on, else the first
  /// with a monitor. Null without any monitor.
  const Output* shown_on() const;
  friend bool operator==(const Outputs&, const Outputs&) = default;
};

/// The change that makes a new monitor show the kiosk.
struct Relighting {
  std::uint64_t light = 0, mode = 0;  ///< Turn this output on in this mode; 0: none.
  /// First turn these outputs off, because their monitors are gone.
  std::vector<std::uint64_t> darken{};
  friend bool operator==(const Relighting&, const Relighting&) = default;
};

/// X itself never turns on a new monitor: a desktop does, and a kiosk has none. A new monitor, or
/// one that cannot show its mode, gets its preferred mode. Choices of staff (another mode, a
/// monitor turned off by a script) stay. `before`: the previous state; absent at the start, when a
/// monitor is turned on only if none shows the kiosk.
Relighting relight(const std::optional<Outputs>& before, const Outputs& now);

/// Matrix that maps a touch on the glass of `on` to the whole screen, by rows, in shares of glass
/// and screen, 0..1: X's "Coordinate Transformation Matrix". Without it X maps a touch screen to
/// the whole screen, however many monitors share it and however they are rotated.
std::array<float, 9> touch_map(const Outputs& outputs, const Output& on);

}  // namespace onggi::render
