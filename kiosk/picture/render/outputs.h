#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace onggi::render {

/// A connector of the graphics card, with what is plugged into it, as RandR tells of it.
struct Output {
  enum class Turned : std::uint8_t { upright, left, upside_down, right };
  std::uint64_t id = 0;
  bool connected = false;
  std::uint64_t monitor = 0;                ///< A hash of its EDID; 0: it tells nothing of itself.
  std::vector<std::uint64_t> modes{};       ///< That it can show, its own choice first.
  std::uint64_t mode = 0;                   ///< That it shows; 0: it is dark.
  int x = 0, y = 0, width = 0, height = 0;  ///< Of the whole screen, pixels.
  Turned turned = Turned::upright;
  friend bool operator==(const Output&, const Output&) = default;
};

/// All connectors, and the screen that X makes of them.
struct Outputs {
  int width = 0, height = 0;  ///< Pixels.
  std::uint64_t primary = 0;  ///< An Output::id; 0: none was named.
  std::vector<Output> all{};

  /// Where the kiosk is shown: the primary output, else the first that shows something, else the
  /// first with a monitor; null without any monitor.
  const Output* shown_on() const;
  friend bool operator==(const Outputs&, const Outputs&) = default;
};

/// What is to be done so that a monitor that was plugged in shows the kiosk.
struct Relighting {
  std::uint64_t light = 0, mode = 0;    ///< This output in this mode; 0: nothing.
  std::vector<std::uint64_t> darken{};  ///< Before: outputs that nothing is plugged into any more.
  friend bool operator==(const Relighting&, const Relighting&) = default;
};

/// X itself never lights what is plugged into it: a desktop does, and a kiosk has none. A monitor
/// that came, or whose mode it cannot show, is lit as it would choose itself. What somebody chose
/// (a mode of its own, a monitor switched off by a script) stays. `before`: as it was last looked
/// at; none at the first look, when only a kiosk that no monitor shows is lit.
Relighting relight(const std::optional<Outputs>& before, const Outputs& now);

/// Where a touch on the glass of `on` lies on the whole screen, by rows, in shares of glass and
/// screen, 0..1: X's "Coordinate Transformation Matrix". X gives a touch screen the whole of its
/// screen, however many monitors share it and however they are turned.
std::array<float, 9> touch_map(const Outputs& outputs, const Output& on);

}  // namespace onggi::render
