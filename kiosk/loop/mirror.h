#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/profile/profile.h"
#include "engine/scene/hands.h"

namespace onggi::loop {

/// The main thread's copy of the clay, kept by applying changed rows. Row means are kept too, so
/// that a profile costs O(rows). Main thread only.
class Mirror {
 public:
  /// The grid of a new scene: even rows at first, over `height` metres, all at the lump's radii.
  void reset(int rows, int sectors, double height, double floor_height, double outer, double inner);
  /// `radii`: `sectors` outer radii, then `sectors` inner ones, metres.
  void apply(int row, const std::vector<float>& radii);
  /// How wet the clay is at even heights, foot to rim.
  void moisten(std::vector<float> wet) { wet_ = std::move(wet); }
  /// Where the middle of a row now is, and the rim and the floor, metres.
  void stack(int row, double middle, double rim, double floor);
  /// The row is torn, or whole.
  void tear(int row, bool torn);

  int rows() const { return rows_; }
  int sectors() const { return sectors_; }
  double height() const { return height_; }
  double floor_height() const { return floor_height_; }
  const std::vector<float>& outer() const { return outer_; }  ///< rows x sectors.
  const std::vector<float>& inner() const { return inner_; }
  /// 0 dry .. 1 dripping, at even heights from foot to rim; empty where the pot is wet all alike.
  const std::vector<float>& wet() const { return wet_; }
  bool torn(int row) const { return torn_[static_cast<std::size_t>(row)]; }
  /// How thin the wall is where the torn rows are thinnest, metres; nothing where none is torn.
  /// O(torn rows x sectors).
  std::optional<double> torn_wall() const;
  Profile profile() const;
  /// Mean radius of a face at height `h` (clamped), metres.
  double radius_at(double h, WallSide side) const;

 private:
  int rows_ = 0, sectors_ = 0;
  double height_ = 0, floor_height_ = 0;
  std::vector<float> outer_, inner_, wet_;
  std::vector<double> mean_outer_, mean_inner_, middle_;
  std::vector<bool> torn_;
};

}  // namespace onggi::loop
