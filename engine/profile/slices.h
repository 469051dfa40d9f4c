#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "engine/profile/mesh.h"

namespace onggi::extraction {

/// A right-handed frame on an axis: heights along `up` from `origin`, `across` and `along` in the
/// plane. Unit vectors.
struct AxisFrame {
  Vec3 origin;
  Vec3 up{0, 1, 0};
  Vec3 across{1, 0, 0};
  Vec3 along{0, 0, 1};
};

/// The frame on the line through `origin` along `direction` (any length but 0).
AxisFrame axis_frame(Vec3 origin, Vec3 direction);

/// A piece of a mesh's outline in a cutting plane.
struct CutSegment {
  Vec2 a, b;    ///< In the frame's (across, along).
  Vec2 facing;  ///< Direction of the surface's outside, not normalised.
  /// How much further out, times the radius, a surface of revolution through the triangle's corners
  /// lies than a and b, which are on its edges. Frame units squared.
  double bulge_a = 0.0, bulge_b = 0.0;
};

/// Vertices of a mesh in an axis frame, ready to be cut at any heights. O(vertices) to make.
class Slicer {
 public:
  Slicer(const TriangleMesh& mesh, const AxisFrame& frame);

  double lowest() const { return lowest_; }
  double highest() const { return highest_; }
  /// The outline at `height`. O(triangles). Allocates.
  std::vector<CutSegment> cut(double height) const;
  /// `take(i, outline)` for each of `heights` (rising), in order. No more than `most` segments are
  /// held at a time, or one outline: a mesh of slivers has millions of them, 72 bytes each.
  /// O(triangles) for each time that so many are full, and O(segments). Allocates.
  using TakeOutline = std::function<void(std::size_t i, std::span<const CutSegment> outline)>;
  void each_cut(std::span<const double> heights, const TakeOutline& take,
                std::size_t most = kMostHeld) const;
  static constexpr std::size_t kMostHeld = 1u << 20;
  /// Vertex `i` as (across, along) and height.
  Vec2 plane(std::size_t i) const { return plane_[i]; }
  double height(std::size_t i) const { return height_[i]; }
  const TriangleMesh& mesh() const { return *mesh_; }

 private:
  void cut_into(std::span<std::vector<CutSegment>> out, std::span<const double> heights) const;
  /// How many triangles each of `heights` may cut, or a few that lie in it besides.
  std::vector<std::size_t> counts_at(std::span<const double> heights) const;
  const TriangleMesh* mesh_;
  std::vector<Vec2> plane_;
  std::vector<double> height_;
  double lowest_ = 0.0, highest_ = 0.0;
};

/// The crossing of a ray from the centre with the outline.
struct Crossing {
  double radius = 0.0;
  bool outward = true;  ///< The surface there looks away from the centre.
};

/// Even rays round the axis; ray k at the angle (k + 0.5) * 2 pi / count. Finds a point's place
/// between them without an arc tangent: the order of y / (|x| + |y|) is the order of angles.
class RayFan {
 public:
  explicit RayFan(int count);
  std::size_t count() const { return directions_.size(); }
  Vec2 direction(std::size_t ray) const { return directions_[ray]; }
  /// The first ray at or after `p`'s angle; count() after the last. p is not the origin.
  std::size_t first_after(Vec2 p) const;

 private:
  std::vector<Vec2> directions_;
  std::vector<double> turns_;           // of each ray, rising, 0..4
  std::vector<std::size_t> from_turn_;  // first ray at or after each of many even turns
};

/// All crossings of one outline with every ray of a fan, each ray's outermost first. Reuses its
/// memory from one outline to the next.
class RayCrossings {
 public:
  explicit RayCrossings(const RayFan& fan) : fan_(&fan) {}
  /// Crosses `outline` with the rays from `centre`. Allocates only if it needs more memory than
  /// before.
  void meet(std::span<const CutSegment> outline, Vec2 centre);
  /// The outermost crossing's radius for each ray, 0 if there is none: meet() without sorting.
  std::span<const double> outermost(std::span<const CutSegment> outline, Vec2 centre);
  std::span<const Crossing> ray(std::size_t k) const {
    return std::span(sorted_).subspan(begin_[k], begin_[k + 1] - begin_[k]);
  }
  const RayFan& fan() const { return *fan_; }

 private:
  template <class Take>
  void each(std::span<const CutSegment> outline, Vec2 centre, const Take& take) const;

  const RayFan* fan_;
  std::vector<double> furthest_;
  std::vector<std::pair<std::size_t, Crossing>> met_;
  std::vector<Crossing> sorted_;
  std::vector<std::size_t> begin_, next_;
};

/// `values` (sorted here) agree about a radius where the shortest interval that holds `share` of
/// `all` lies: its ends. Both 0 where there are too few values. Robust against any handle that
/// covers less than 1 - share of the circle.
struct Agreement {
  double low = 0.0, high = 0.0;
  bool found = false;
  double middle() const { return 0.5 * (low + high); }
};
Agreement agreement(std::vector<double>& values, std::size_t all, double share);

}  // namespace onggi::extraction
