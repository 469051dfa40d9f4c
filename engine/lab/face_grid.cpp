#include "engine/lab/face_grid.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi::lab {
namespace {

constexpr double kRound = 2.0 * portable::kPi;

// A place between two elements of a row, or of a column.
struct Between {
  std::size_t first, second;
  double share;  // of the second
};

// At `angle` (rad) round the face.
Between round_at(const FaceGrid& face, double angle) {
  const double at = (angle - face.turned) * face.sectors / kRound - 0.5;
  const double whole = std::floor(at);
  const auto wrapped = [&](double n) {
    const double turns = std::floor(n / face.sectors);
    return static_cast<std::size_t>(n - turns * face.sectors) %
           static_cast<std::size_t>(face.sectors);
  };
  return {wrapped(whole), wrapped(whole + 1.0), at - whole};
}

}  // namespace

FaceGrid face_of(const Clay& clay, WallSide side, double low, double high) {
  FaceGrid face;
  face.sectors = clay.sectors();
  face.thickness = clay.first_thickness();
  const int first = clay.first_row_above(low), end = clay.first_row_above(high);
  face.rows = end - first;
  if (face.rows > 0) face.bottom = clay.row_height(first);
  face.radius.reserve(static_cast<std::size_t>(std::max(face.rows, 0)) *
                      static_cast<std::size_t>(face.sectors));
  for (int j = first; j < end; ++j)
    for (const float r : side == WallSide::outside ? clay.outer(j) : clay.inner(j))
      face.radius.push_back(double{r});
  return face;
}

template <class Real>
FaceGrid face_of(const PlainWall<Real>& wall, WallSide side) {
  FaceGrid face{wall.rows(), wall.sectors(), wall.row_height(0), wall.thickness(), 0.0, {}};
  face.radius.assign(wall.face(side).begin(), wall.face(side).end());
  return face;
}
template FaceGrid face_of(const PlainWall<float>&, WallSide);
template FaceGrid face_of(const PlainWall<double>&, WallSide);

double radius_at(const FaceGrid& face, double height, double angle) {
  const double at = std::clamp((height - face.bottom) / face.thickness, 0.0, face.rows - 1.0);
  const double whole = std::min(std::floor(at), face.rows - 2.0);
  const Between b = round_at(face, angle);
  const double* below =
      face.radius.data() + static_cast<std::size_t>(whole) * static_cast<std::size_t>(face.sectors);
  const double* above = below + face.sectors;
  const double low = below[b.first] + b.share * (below[b.second] - below[b.first]);
  const double high = above[b.first] + b.share * (above[b.second] - above[b.first]);
  return low + (at - whole) * (high - low);
}

FaceDifference difference(const FaceGrid& face, const FaceGrid& truth) {
  std::vector<Between> round;
  for (int i = 0; i < truth.sectors; ++i)
    round.push_back(round_at(face, (i + 0.5) * kRound / truth.sectors + truth.turned));
  FaceDifference out;
  double squares = 0.0;
  long count = 0;
  for (int j = 0; j < truth.rows; ++j) {
    const double at = (truth.bottom + j * truth.thickness - face.bottom) / face.thickness;
    const double whole = std::floor(at);
    if (whole < 0.0 || whole + 1.0 > face.rows - 1.0) continue;
    const double share = at - whole;
    const double* below = face.radius.data() +
                          static_cast<std::size_t>(whole) * static_cast<std::size_t>(face.sectors);
    const double* above = below + face.sectors;
    const double* true_row =
        truth.radius.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(truth.sectors);
    for (const Between& b : round) {
      const double low = below[b.first] + b.share * (below[b.second] - below[b.first]);
      const double high = above[b.first] + b.share * (above[b.second] - above[b.first]);
      const double off = std::fabs(low + share * (high - low) - *true_row++);
      squares += off * off;
      out.most = std::max(out.most, off);
    }
    count += truth.sectors;
  }
  if (count > 0) out.rms = std::sqrt(squares / static_cast<double>(count));
  return out;
}

double displaced(const FaceGrid& face, double fresh) {
  double sum = 0.0;
  for (const double r : face.radius) sum += std::fabs((fresh - r) * (fresh + r));
  return 0.5 * sum * face.thickness * kRound / face.sectors;
}

}  // namespace onggi::lab
