#pragma once

#include <functional>
#include <vector>

#include "engine/profile/profile.h"
#include "engine/scene/scene_def.h"
#include "engine/script/choreography.h"

namespace onggi::script {

/// Plans how one fingertip brings a lump to an outline: passes from the foot upwards, each as deep
/// as clay takes in one go, inside where the wall must be wider, outside where it must be narrower.
/// Where walls go as a whole and clay is not kept, narrowing alone would close a neck; there the
/// other hand holds the wall from inside, so that the wall gets thin. It keeps account of the shape
/// that the passes should leave and, if the scene keeps volume, of its height. Allocates; not for
/// the tick.
class Former {
 public:
  /// `haste` multiplies the speed of every pass.
  Former(const SceneDef& scene, Choreography& hand, double haste = 1.0);

  /// The wanted outline: outer radius at a height, m, clipped to the clay's limits.
  void set_goal(std::function<double(double)> outer_at);
  /// The rim's height after the passes so far, m.
  double height() const { return spacing_ * static_cast<double>(outer_.size()); }

  /// Widens from inside until the outside can cut the outer face to the goal, the wall thinned on
  /// the way.
  void open(std::string_view phase, double speed);
  /// Narrows from outside to the goal.
  void narrow(std::string_view phase, double speed);
  /// One slow pass along the whole goal, on one side.
  void smooth(WallSide side, std::string_view phase, double speed);
  /// smooth() at `speed`, without haste, because the eye sees the rise of each turn.
  void finish(WallSide side, std::string_view phase, double speed);

  /// Lifts the hands; the wheel slows.
  void rest();

 private:
  bool holds() const { return scene_.walls && !scene_.volume; }
  double room_of(std::size_t n, const std::vector<double>& centre) const;
  double height_of(std::size_t n) const { return (static_cast<double>(n) + 0.5) * spacing_; }
  std::vector<double> centre_path(WallSide side, const std::vector<double>& face) const;
  void pass(WallSide side, const std::vector<double>& face, std::size_t first, std::size_t last,
            std::string_view phase, double speed);
  double seconds_of_water() const;
  void wet_every_third_pass();
  void aim();
  void restack(const std::vector<double>& outer_before, const std::vector<double>& inner_before);
  double area(double outer, double inner, double height) const;

  const SceneDef& scene_;
  Choreography& hand_;
  double haste_, radius_, spacing_;
  double floor_;  // m
  std::function<double(double)> goal_;
  std::vector<double> goal_outer_, goal_inner_;  // wanted, by height
  std::vector<double> outer_, inner_;            // expected so far
  int passes_ = 0;
  double wet_ = 0.0;  // after the passes, ignoring drying
};

}  // namespace onggi::script
