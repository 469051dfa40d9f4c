#pragma once

#include <cstdint>

#include "engine/clay/clay_view.h"

namespace onggi::device {

/// Which hands work the wall. Both: one on each face with the wall between them, as potters open
/// and collar a pot; where it is solid, or too narrow for a hand, the outer one alone.
enum class Grip : std::uint8_t { both, outside, inside };
/// The three of them, one after the other.
constexpr Grip next_grip(Grip now) {
  return now == Grip::both ? Grip::outside : now == Grip::outside ? Grip::inside : Grip::both;
}

/// How hands stand at a wall so that the face they work is where it is asked to be. Each touches it
/// square on: on a shoulder the outer hand lies above the height it works at and the inner one
/// below, in a bowl the other way round; standing level with it they would press a radius (1 - cos)
/// into a slanted wall. Reads the clay as it now stands; nothing is known here of any target. Pure,
/// allocates nothing.
class WallHold {
 public:
  /// What a hand works with: HandInput::tool, and the radius of that ball, m; of another tool, how
  /// far the face it works is from its middle, and how far it reaches down (0: as a ball).
  struct Part {
    std::uint8_t tool = 0;
    double radius = 0.008;
    double below = 0;
  };
  struct Stand {
    bool there = false;
    double radius = 0, height = 0;  ///< Of the ball's middle, m.
    Part part = {};
  };
  struct Hands {
    Stand outside, inside;
  };

  /// A broad part to work with, and a fine one for the inside of a pot too narrow for it.
  WallHold(Part broad, Part fine) : broad_(broad), fine_(fine), inner_(fine) {}

  /// Takes hold at `height`, m. What works inside is chosen by the narrowest place on its way down
  /// from the mouth, and kept until the next hold.
  void take(const ClayView& clay, Grip grip, double height);
  Grip grip() const { return grip_; }

  /// Between which heights the hands can work, m: not through the wheel, inside not through the
  /// floor; hands that hold a wall stay below its rim, one hand may go a radius over it.
  double lowest(const ClayView& clay) const;
  double highest(const ClayView& clay) const;
  /// Radius of the face the grip works, m.
  double face(const ClayView& clay, double height) const;
  /// There is no inside at `height`: what is pressed away there, no hand can push out again.
  bool solid(const ClayView& clay, double height) const;
  /// Where the hands are for that face to be `reach` from the axis at `height`. Pressed inwards, a
  /// wall thicker than kThick gets thinner, the hand inside staying where it is; otherwise it goes
  /// along. Holding a wall they never close it over the finger inside, and open a bore that is
  /// narrower than one: the outer hand alone can close it.
  /// `wall`: how thick the wall between both is to be, m; as thick as it is (0) otherwise. They
  /// close on a thicker one by kBite at the most, so that a pass thins it and does not cut.
  static constexpr double kBite = 0.002, kThick = 0.010;
  Hands stand(const ClayView& clay, double reach, double height, double wall = 0) const;
  /// Of the wall about `height`, m.
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
