#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/surface/surface.h"

namespace onggi::surface {

inline constexpr int kWhole = 1024;    ///< A share of 1, as a station has it.
inline constexpr int kUnit = 1 << 14;  ///< Length of a station's direction.

/// One place of a stroke, complete: all that a law knows of the hand there. A law works from each
/// station to the next, so a stroke cut in two at a station is the stroke.
struct Station {
  std::int32_t along = 0;  ///< From the foot along the outline, um.
  std::int32_t round = 0;  ///< Round the pot, in kParts of a sector; goes on after a turn.
  /// The direction across the tool's way, of length kUnit, to its left as seen from outside: how
  /// far along the outline and how far round.
  std::int16_t across_along = -kUnit, across_round = 0;
  std::uint16_t pressure = kWhole;  ///< 0..kWhole.
  std::uint16_t load = kWhole;      ///< What is left in the brush, 0..kWhole.
  std::uint32_t age = 0;            ///< Since the layer under the tool was laid, ms.

  friend bool operator==(const Station&, const Station&) = default;
};

/// A hand's place at a moment, between which it moves straight.
struct HandPlace {
  double along = 0.0;     ///< From the foot along the outline, m.
  double turns = 0.0;     ///< Round the pot; goes on after 1.
  double pressure = 1.0;  ///< 0..1.
  double age = 0.0;       ///< Since the layer under the tool was laid, s.
};

/// Turns a hand's places into stations, kStationWay apart along its way, as they come: a way that
/// is given in two parts leaves the same stations.
class Tracer {
 public:
  /// Distance from a station to the next, m.
  static constexpr double kStationWay = 5e-4;
  /// `reach`: the way that a full brush goes, m, > 0.
  Tracer(const Surface& surface, double reach) : surface_(&surface), reach_(reach) {}

  /// The next place; appends the stations up to it. Places beyond the outline or 1000 turns are
  /// moved to those ends.
  void go(const HandPlace& to);
  /// Ends the way: a last station where the hand left the pot, unless one stands there.
  void lift();
  const std::vector<Station>& stations() const { return stations_; }

 private:
  void put(const HandPlace& at, double across_along, double across_round);

  const Surface* surface_;
  double reach_;
  double gone_ = 0.0;   // the whole way, m
  double since_ = 0.0;  // since the last station, m
  bool began_ = false;
  HandPlace last_;
  double across_along_ = -1.0, across_round_ = 0.0;
  std::vector<Station> stations_;
};

}  // namespace onggi::surface
