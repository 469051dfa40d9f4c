#pragma once

#include "engine/clay/clay_view.h"
#include "engine/math/vec.h"
#include "engine/profile/profile.h"
#include "engine/scene/hands.h"

namespace onggi::device {

/// Draws a round trimmer down the foot of a pot from outside, again and again, until the foot
/// matches the target. Each pass is as deep as clay can come away. Two hands cannot shape the foot,
/// because it is solid. Never cuts into the target. Reads the current clay. Main thread; allocates
/// nothing.
class TrimPass {
 public:
  static constexpr double kDown = 0.016;   ///< m/s along the foot.
  static constexpr double kDeep = 0.0025;  ///< m that a pass removes at most.
  static constexpr double kAbove = 0.006;  ///< m over the floor where a pass begins.
  static constexpr int kMostPasses = 12;

  /// `tool`: HandInput::tool of a disc or ball with this radius, m.
  TrimPass(std::uint8_t tool, double radius) : tool_(tool), radius_(radius) {}

  void begin(const ClayView& clay, const Profile& target);
  /// Once a frame.
  void follow(const ClayView& clay, const Profile& target, double dt);
  bool done() const { return stage_ == Stage::off; }
  /// `right`: as PointerLead::input.
  HandInput input(Vec3 right) const;

 private:
  enum class Stage : std::uint8_t { setting, cutting, leaving, rising, off };
  bool left_to_do(const ClayView& clay, const Profile& target) const;
  void next_pass(const ClayView& clay, const Profile& target);
  template <class Face>
  double centre(double height, const Face& face) const;

  std::uint8_t tool_;
  double radius_;
  Stage stage_ = Stage::off;
  int passes_ = 0;
  double height_ = 0, top_ = 0, clear_ = 0;
  double at_ = 0;        ///< The tool's middle, m from the axis.
  double was_[64] = {};  ///< Where it would touch at the start of the pass, by height.
};

}  // namespace onggi::device
