#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kiosk/picture/render/ribbons.h"

namespace onggi::render {

/// A corner of a drawn mesh in the picture.
struct MeshCorner {
  EdgePoint point;
  glm::vec3 own{0.0f};  ///< The caller's: mixed along an edge of the mesh, as depths are.
};

/// The outermost of a drawn mesh on each line of the picture (the rows of its pixels), or in each
/// of its columns. Lines find steep outlines, columns nearly level ones. It is exact: on a line an
/// edge of the mesh is outermost, never the middle of a triangle. Plain numbers; any thread.
class Silhouette {
 public:
  enum class By : std::uint8_t { lines, columns };
  struct Most {
    EdgePoint point;
    glm::vec3 own{0.0f};
    bool is_side = false;  ///< As take() was told.
    bool any = false;      ///< The mesh reaches this line.
  };

  /// Of the lines of a frame of `frame` pixels, or those of them from pixel `from` up to `to`.
  /// Allocates.
  Silhouette(By by, glm::vec2 frame, float from = 0.0f, float to = 1e9f);
  /// Takes an edge of the mesh. `is_side` is given back with what it makes outermost.
  void take(const MeshCorner& one, const MeshCorner& other, bool is_side = true);
  /// The first line of most().
  std::size_t first() const { return first_; }
  /// By line from the lowest, or by column from the left: [0] the least, [1] the greatest.
  std::array<std::vector<Most>, 2>& most() { return most_; }

 private:
  int along_, across_;  // the axis that numbers the lines, and the other one
  std::size_t first_ = 0;
  std::array<std::vector<Most>, 2> most_;
};

/// Metres by which what lies behind an edge is farther, and by which what hides it is nearer.
inline constexpr float kBehind = 0.004f, kHides = 0.012f;
/// EdgePoint::depths.z of what stands on no wheel head.
inline constexpr float kElsewhere = -1.0f;

/// Where the outermost lies more than this beside that of the next line, it leaps, pixels.
inline constexpr float kLeap = 1.5f;

/// EdgePoint::most_out of such an end: something else may begin beside it.
inline constexpr float kAtLeapsEnd = 0.75f;

/// The lines to draw (add_ribbon) through the points of `edge`, one a line or a column, none where
/// there is no edge. `greatest`: they are the greatest on their lines, not the least.
/// - joined: a leap is a level piece between two lines (for By::lines alone);
/// - ended: a line ends there, at a point with kAtLeapsEnd. What is level there, the other way of
///   going finds.
enum class AtLeap : std::uint8_t { joined, ended };
std::vector<std::vector<EdgePoint>> lines_through(const std::vector<std::optional<EdgePoint>>& edge,
                                                  Silhouette::By by, bool greatest, AtLeap at);

}  // namespace onggi::render
