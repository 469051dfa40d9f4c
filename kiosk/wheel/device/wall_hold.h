#pragma once

#include <cstdint>

#include "engine/clay/clay_view.h"

namespace onggi::device {

/// Which hands work the wall. Both: one on each face with the wall between them, as potters open
/// and collar a pot. If the wall is solid or too narrow for a hand, only the outer one.
enum class Grip : std::uint8_t { both, outside, inside };
constexpr Grip next_grip(Grip now) {
  return now == Grip::both ? Grip::outside : now == Grip::outside ? Grip::inside : Grip::both;
}

/// Positions the hands at a wall so that the worked face is where it should be. Each hand touches
/// the wall squarely. On a shoulder the outer hand is above the height it works at and the inner
/// one below; in a bowl the other way round. A hand level with its height would press radius (1 -
/// cos) too deep into a slanted wall. Reads the current clay and knows no target. Pure, allocates
/// nothing.
class WallHold {
 public:
  /// A hand's part: HandInput::tool and the ball's radius, m. For other tools, the distance from
  /// the middle to the worked face, and its reach downwards (0: like a ball).
  struct Part {
    std::uint8_t tool = 0;
    double radius = 0.008;
    double below = 0;
  };
  struct Stand {
    bool there = false;
    double radius = 0, height = 0;  ///< The ball's middle, m.
    Part part = {};
  };
  struct Hands {
    Stand outside, inside;
  };

  /// A broad part for normal work, and a fine one for a pot too narrow for it inside.
  WallHold(Part broad, Part fine) : broad_(broad), fine_(fine), inner_(fine) {}

  /// Takes hold at `height`, m. The inside part is chosen by the narrowest place between the mouth
  /// and `height`, and kept until the next hold.
  void take(const ClayView& clay, Grip grip, double height);
  Grip grip() const { return grip_; }

  /// The range of heights for the hands, m: above the wheel, and inside above the floor. Hands that
  /// hold a wall stay below its rim; a single hand may go a radius above it.
  double lowest(const ClayView& clay) const;
  double highest(const ClayView& clay) const;
  /// Radius of the worked face, m.
  double face(const ClayView& clay, double height) const;
  /// True if there is no inside at `height`: clay pressed in there cannot be pushed out again.
  bool solid(const ClayView& clay, double height) const;
  /// Positions of the hands that put the face `reach` from the axis at `height`. Pressed inwards, a
  /// wall thicker than kThick gets thinner, because the inside hand stays; a thinner wall moves
  /// along. Hands that hold a wall never close it over the finger inside, and they open a bore that
  /// is narrower than the finger. Only the outer hand alone can close it.
  /// `wall`: wanted thickness between both, m; 0: unchanged. They squeeze a thicker wall by at most
  /// kBite, so that a pass thins it and does not cut.
  static constexpr double kBite = 0.002, kThick = 0.010;
  Hands stand(const ClayView& clay, double reach, double height, double wall = 0) const;
  /// Thickness of the wall around `height`, m.
  static double thickness(const ClayView& clay, double height);

 private:
  struct Faces {
    double outer = 0, inner = 0;
  };
  static Faces seen(const ClayView& clay, double height);
  double slope(const ClayView& clay, double height) const;

  Part broad_, fine_, inner_;
  Grip grip_ = Grip::both;
};

}  // namespace onggi::device
