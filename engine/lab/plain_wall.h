#pragma once

#include <cstdint>
#include <vector>

#include "engine/clay/clay_def.h"
#include "engine/clay/wall_side.h"
#include "engine/math/vec.h"

namespace onggi::lab {

/// How clay gives way in one step.
enum class TimeRule : std::uint8_t {
  printed,  ///< Lee, Han & Choi 2008, eq. 6: a tenth of the press a tick, whatever the tick.
  exact,    ///< e^(-dt/tau), the tool at the step's end, force before the step.
  shipped,  ///< e^(-dt/tau), the tool in the step's middle, force the step's mean (contact.md).
};
/// How the elements' presses are summed to a force.
enum class Quadrature : std::uint8_t {
  none,   ///< Eq. 9: a plain sum, c_v an element.
  area,   ///< Each by its area, radius dtheta dh.
  edges,  ///< And elements that the ball's edge crosses by the share that it covers, turned with a
          ///< wall that leans (contact.md).
};

struct PlainLaw {
  TimeRule rule = TimeRule::shipped;
  Quadrature quadrature = Quadrature::edges;
  double relaxation_time = 0.00949;  ///< s, > 0.
  double stiffness = 5e6;            ///< N/m^3.
  double c_eta = 10.0;               ///< Printed rule: steps in which clay gives way, > 0.
  double c_v = 0.864;                ///< Quadrature none: N per metre of an element's press.
};

/// A ball's path in one step, and the wheel's turn in it. Studio frame.
struct BallWay {
  WallSide side = WallSide::outside;
  Vec3 from, to;            ///< m
  double radius = 0.008;    ///< m
  double angle_from = 0.0;  ///< Of the wheel, rad.
  double angle_to = 0.0;
  double seconds = 0.001;  ///< > 0
};

/// A band of a cylinder's wall in circular sector elements, written a second time as plainly as
/// possible, in floats or doubles: no vectors, no extents, no rim, no floor, no second face. The
/// engine is measured against it, and each correction of the law can be undone in it alone. Element
/// (j, i) as in Clay.
template <class Real>
class PlainWall {
 public:
  /// The rows of `def` whose middle lies in low..high (m). Allocates.
  PlainWall(const ClayDef& def, double low, double high);

  /// Presses the ball on its side for one step. Returns the force on it (N, studio frame), the
  /// step's mean if the rule has one. No allocation.
  Vec3 step(const PlainLaw& law, const BallWay& way) noexcept;

  int rows() const { return rows_; }
  int sectors() const { return sectors_; }
  double row_height(int j) const { return bottom_ + j * thickness_; }
  double thickness() const { return thickness_; }
  /// rows() x sectors() radii, row by row, m.
  const std::vector<Real>& face(WallSide side) const {
    return side == WallSide::outside ? outer_ : inner_;
  }

 private:
  double slope(WallSide side, double height, double angle, double radius) const;

  int rows_ = 0, sectors_ = 0;
  double bottom_ = 0.0, thickness_ = 0.0;
  Real nearest_{}, farthest_{};  // limits of the pressed face
  std::vector<Real> outer_, inner_, cos_, sin_;
};

extern template class PlainWall<float>;
extern template class PlainWall<double>;

}  // namespace onggi::lab
