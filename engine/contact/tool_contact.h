#pragma once

#include <optional>

#include "engine/contact/place.h"
#include "engine/contact/tool.h"

namespace onggi {

/// A tool's path through one tick, studio frame: a straight line, while the wheel turns evenly.
struct ToolSweep {
  const ToolShape* shape = nullptr;
  ToolSize size;          ///< No zeros: see sized().
  Vec3 from, to;          ///< Centre of the working part, m.
  Vec3 along{0, 1, 0};    ///< Direction of its length; unit.
  Vec3 across{0, 0, 1};   ///< Direction of its thickness; unit, at a right angle to `along`.
  double angle_from = 0;  ///< Wheel angle, rad.
  double angle_to = 0;    ///< Not wrapped: angle_to - angle_from is the tick's turn.
  double seconds = 0;     ///< > 0.
  SideWish wish = SideWish::by_position;
};

/// How many equal steps a sweep needs, 1..kMostSteps. In one step:
///
///- the tool moves at most a quarter of its smallest feature;
///- the clay under it moves at most an eighth of what passes over it (a light touch is only a
///  quarter radius wide);
///- at most a quarter of the clay's relaxation time passes: `relaxation_time` (s) times the tool's
///  share. The target is held at its place in the step's middle, which is wrong by (dt/tau)^2 / 12
///  of the press.
///
/// `pressed` is the face that the tool already presses, if any. It tells how far from the axis that
/// clay is, and whether a flat tool lies on it with its face.
int steps_for(const ToolSweep& sweep, double relaxation_time,
              std::optional<WallSide> pressed = std::nullopt) noexcept;
/// Enough for a 1 mm ball, 0.1 m from the axis, on a wheel of 600 rpm, in a tick of 5 ms.
inline constexpr int kMostSteps = 256;

namespace contact {

/// The part of a press on a face of the wall, which pushes the wall aside. Excludes the rim and the
/// floor.
struct FacePush {
  Vec3 force;         ///< N.
  double normal = 0;  ///< Sum of the elements' normal forces, N.
  double depth = 0;   ///< Deepest press on a face, m.
};

}  // namespace contact

/// One tool's contact with the clay over time: where it works, and how hard it presses. No
/// allocation.
class ToolContact {
 public:
  /// Runs one step of a sweep: from share n/of to (n+1)/of. Chooses the place while the tool is
  /// clear, presses, and adds to reaction(). Force in the studio frame.
  void step(Clay& clay, const ToolSweep& sweep, int n, int of, const Yielding& yielding) noexcept;

  /// Total since begin_tick(): force and normal are means over the tick, depth is the maximum.
  const Press& reaction() const { return sum_; }
  /// The part of reaction() that pushes the wall aside.
  contact::FacePush on_face() const {
    return {sum_.force - off_face_.force, sum_.normal - off_face_.normal, face_depth_};
  }
  void begin_tick() {
    sum_ = {};
    off_face_ = {};
    face_depth_ = 0.0;
  }
  /// Call when the hand was lifted or is new: the next step chooses the side again.
  void release() { touching_ = false; }

  /// The face of the wall that it works, or worked before it moved onto the rim.
  WallSide side() const { return side_; }
  Place place() const { return on_rim_ ? Place::rim : on_floor_ ? Place::floor : beside(side_); }
  bool touching() const { return touching_; }
  /// The face of the wall that it pressed in its last step, if any.
  std::optional<WallSide> pressed() const {
    return touching_ && !on_rim_ ? std::optional(side_) : std::nullopt;
  }

 private:
  /// Chooses where a tool that was clear stands. False if it is still clear.
  bool choose_place(const Clay& clay, const ToolPlace& place, const body::Ball& lowest,
                    const ToolSweep& sweep) noexcept;
  /// The same for a tool that touches the clay.
  void change_place(const Clay& clay, const body::Ball& lowest) noexcept;

  WallSide side_ = WallSide::outside;
  bool touching_ = false;
  bool on_rim_ = false;
  bool on_floor_ = false;
  Press sum_;
  contact::FacePush off_face_;  // part of sum_ on rim and floor
  double face_depth_ = 0.0;
};

}  // namespace onggi
