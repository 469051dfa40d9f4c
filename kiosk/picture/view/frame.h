#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/math/vec.h"
#include "engine/profile/profile.h"
#include "engine/scene/coil_view.h"
#include "engine/scene/hand_view.h"
#include "kiosk/collection/content/glaze.h"
#include "kiosk/picture/view/camera.h"
#include "kiosk/picture/view/rect.h"
#include "kiosk/picture/view/studio_window.h"

namespace onggi::view {

/// A frame as plain values: screens fill it, render draws it. Pixels from the top left unless
/// noted; colours are display sRGB, straight alpha, 0..1.

struct Color {
  float r = 0, g = 0, b = 0, a = 1;
  friend bool operator==(const Color&, const Color&) = default;
};

enum class Face : std::uint8_t { serif, sans };
enum class Align : std::uint8_t {
  start,
  centre,
  end
};  ///< start and end follow the script's direction.

struct TextStyle {
  Face face = Face::sans;
  float px = 24;  ///< Font size (em) in pixels.
  bool bold = false;
  Align align = Align::start;
  float line_height = 1.4f;     ///< Of px.
  std::string language = "en";  ///< BCP 47, for shaping and line breaks.
  /// A right-to-left paragraph, whatever its first letter; false: the first letter decides.
  bool right_to_left = false;
  friend bool operator==(const TextStyle&, const TextStyle&) = default;
};

/// A paragraph set in `box.w`; the text must fit `box.h` (the layout asks TextMeasure first).
struct Text {
  Rect box;
  std::string text;
  TextStyle style;
  Color color;
  friend bool operator==(const Text&, const Text&) = default;
};

/// A filled rectangle with round corners, and a border drawn inside its edge.
struct Box {
  Rect rect;
  float radius = 0;
  Color fill;
  float border = 0;
  Color border_color;
  friend bool operator==(const Box&, const Box&) = default;
};

/// An antialiased line; a colour for every point.
struct Line {
  std::vector<std::pair<float, float>> points;
  std::vector<Color> colors;  ///< One for all, or one a point.
  float width = 2;
  friend bool operator==(const Line&, const Line&) = default;
};

/// The name of a picture that the renderer keeps (made with Renderer::make_*). 0 is none.
using PictureId = std::uint32_t;

struct Picture {
  Rect box;  ///< Fitted inside, aspect kept, centred.
  PictureId id = 0;
  float opacity = 1;
  friend bool operator==(const Picture&, const Picture&) = default;
};

using Item = std::variant<Text, Box, Line, Picture>;

/// The finish of the clay's surface; `firing` is between clay, or another glaze, and the new one.
enum class Finish : std::uint8_t { clay, firing, fired };

/// The glass on a fired pot. Default: a coat of celadon.
struct Glazing {
  content::GlazeLook look;
  double coat = 1.0;  ///< Its thickness as a share of 0.5 mm, 0 (bare) .. 4.
  friend bool operator==(const Glazing&, const Glazing&) = default;
};

/// A pot between two finishes.
struct FiringView {
  std::optional<Glazing> from;  ///< The old glaze; absent: dry clay.
  double done = 0;              ///< 0 none .. 1 all of the new glaze.
  double glow = 0;              ///< 0 cold .. 1 white heat's red.
  friend bool operator==(const FiringView&, const FiringView&) = default;
};

/// The vessel that the renderer was given, beside the pot: it stands on the same ground in its own
/// studio, so that both have the same light; `camera` differs from the pot's only by its centre.
struct VesselView {
  Camera camera;
  double angle = 0;  ///< Rotation about its axis, rad.
  friend bool operator==(const VesselView&, const VesselView&) = default;
};

/// The pot in its studio. Its shape is the ClayView that the renderer was given.
struct PotView {
  Camera camera;
  CoilOnRim coil;          ///< What is laid of a ring of coil.
  double wheel_angle = 0;  ///< Of the wheel head, rad,
  double clay_angle = 0;   ///< and of the clay on it: a pot that was cut off stands still.
  double wetness = 0;      ///< Mean, 0..1.
  /// Wetness at even heights, foot to rim, 0..1, at most 256; empty: `wetness` all over.
  std::vector<float> wetness_by_row;
  double embers = 0;      ///< 0..1: how bright charcoal glows in the pot.
  bool slip_wet = false;  ///< `wetness_by_row` is of the slip: the clay below is leather-hard.
  Finish finish = Finish::clay;
  Glazing glazing;    ///< For `firing` and `fired`.
  FiringView firing;  ///< For `firing`.
  double size = 1;    ///< Remaining share of every length since throwing, 0.5..1.
  double cut_away =
      0;  ///< 0 closed .. 1 open: the front quarter is left out and the wall shown in section.
  bool wheel = true;                 ///< Draw the wheel head.
  double wheel_radius = 0.175;       ///< Of its head, metres, 0.05..0.3.
  double window = kWindowLeft;       ///< Where the studio's window is (studio_window.h), rad.
  std::array<HandView, 2> hands{};   ///< Present hands are drawn with their tools.
  double opacity = 1;                ///< 0..1, against the plaster, for fades.
  std::optional<VesselView> beside;  ///< The vessel that it answers.
  friend bool operator==(const PotView&, const PotView&) = default;
};

/// One picture of the screen. Items are drawn in order over the pot.
struct Frame {
  int width = 0, height = 0;
  std::optional<PotView> pot;
  std::vector<Item> items;
  float fade = 0;  ///< 0 this frame .. 1 the frame the screen changed from (cross-fade).
  std::uint64_t screen_serial = 0;  ///< Changes when the screen changes; the renderer keeps the
                                    ///< last picture of the old one for `fade`.
};

}  // namespace onggi::view
