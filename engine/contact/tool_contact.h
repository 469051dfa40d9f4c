#pragma once

#include <optional>

#include "engine/contact/place.h"
#include "engine/contact/tool.h"

namespace onggi {

/// A tool's path through one tick, studio frame: straight, while the wheel turns evenly.
struct ToolSweep {
  const ToolShape* shape = nullptr;
  ToolSize size;          ///< Nothing left at 0: see sized().
  Vec3 from, to;          ///< Middle of its working part, m.
  Vec3 along{0, 1, 0};    ///< Direction of its length; unit.
  Vec3 across{0, 0, 1};   ///< Of its thickness; unit, at a right angle to `along`.
  double angle_from = 0;  ///< Wheel angle, rad.
  double angle_to = 0;    ///< Not wrapped: angle_to - angle_from is the tick's turn.
  double seconds = 0;     ///< > 0.
  SideWish wish = SideWish::by_position;
};

/// How many equal steps a sweep needs: the tool moves at most a quarter of its smallest feature in
/// one, and the clay under it an eighth of what passes over it (a light touch is only a quarter
/// radius wide), and it lasts at most a quarter of the clay's relaxation time under it,
/// `relaxation_time` (s) times the tool's share: the target is held where it is in a step's middle,
/// which is wrong by (dt/tau)^2 / 12 of the press. `pressed` is the face that it presses already,
/// where it does: then it is known how far from the axis that clay is, and whether a flat tool lies
/// on it with its face. 1..kMostSteps.
int steps_for(const ToolSweep& sweep, double relaxation_time,
              std::optional<WallSide> pressed = std::nullopt) noexcept;
/// Enough for a ball of 1 mm on a wheel of 600 rpm, 0.1 m from the axis, in a tick of 5 ms.
inline constexpr int kMostSteps = 256;

namespace contact {

/// The part of a press that lies on a face of the wall, and pushes the wall aside: not what the rim
/// and the floor bear.
struct FacePush {
  Vec3 force;         ///< N.
  double normal = 0;  ///< Sum of the elements' normal forces, N.
};

}  // namespace contact

/// One tool's contact with the clay, over time: where it works, and the press. No allocation.
class ToolContact {
 public:
  /// One step of a sweep: from share n/of to (n+1)/of. Chooses the place while the tool is clear,
  /// presses, and adds to what reaction() gives. Force in the studio frame.
  void step(Clay& clay, const ToolSweep& sweep, int n, int of, const Yielding& yielding) noexcept;

  /// Sum since begin_tick(): force and normal as means over the tick, depth as the maximum.
  const Press& reaction() const { return sum_; }
  /// The part of reaction() that pushes the wall aside.
  contact::FacePush on_face() const {
    return {sum_.force - off_face_.force, sum_.normal - off_face_.normal};
  }
  void begin_tick() {
    sum_ = {};
    off_face_ = {};
  }
  /// The hand was lifted or is new: the next step chooses the side again.
  void release() { touching_ = false; }

  /// The face of the wall it works, or worked before it came onto the rim.
  WallSide side() const { return side_; }
  Place place() const { return on_rim_ ? Place::rim : on_floor_ ? Place::floor : beside(side_); }
  bool touching() const { return touching_; }
  /// The face of the wall that it pressed in its last step, if any.
  std::optional<WallSide> pressed() const {
    return touching_ && !on_rim_ ? std::optional(side_) : std::nullopt;
  }

 private:
  /// Where a tool that was clear stands; false where it is clear at `at` too.
  bool choose_place(const Clay& clay, const ToolPlace& place, const body::Ball& lowest,
                    const ToolSweep& sweep) noexcept;
  /// The same of one that touches the clay.
  void change_place(const Clay& clay, const body::Ball& lowest) noexcept;

  WallSide side_ = WallSide::outside;
  bool touching_ = false;
  bool on_rim_ = false;
  bool on_floor_ = false;
  Press sum_;
  contact::FacePush off_face_;  // of sum_, what rim and floor bear
};

}  // namespace onggi
