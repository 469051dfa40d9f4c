#include "engine/profile/up.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/math/portable.h"
#include "engine/profile/wall_slice.h"

namespace onggi::extraction {

namespace {

constexpr int kUpSlices = 24;

constexpr double kAlong = 0.5;  ///< Cosine: an up within 60 degrees of the axis is meant.

/// What each sign is worth at its most, as log odds.
constexpr double kHollow = 6.0, kFile = 1.5, kStands = 1.0, kHandles = 0.8, kMass = 0.5;
/// A hollow that holds this much of the cylinder round the vessel is worth all of kHollow.
constexpr double kHoldsAll = 0.4;
/// Feet are hollow up to about the first depth; from the second on, of the height, it is no foot.
constexpr double kFootDeep = 0.08, kMouthDeep = 0.36;
/// What a hollow is worth that is as shallow as a foot's.
constexpr double kShallow = 0.25;
/// What a hollow is worth whose walls are seen from behind: perhaps the scan has no base.
constexpr double kBehind = 0.25;

/// A file stands on y (glTF's rule), or on z where it comes from a drawing board.
constexpr double kOnZ = 0.7, kOnX = 0.3, kAskew = 0.1;
constexpr double kAligned = 0.966;  // cosine of 15 degrees
/// Handles count in full where this share of the surface stands off.
constexpr double kHandled = 0.03;

double hollow(const EndSigns& end) {
  const double t = std::clamp((end.depth - kFootDeep) / (kMouthDeep - kFootDeep), 0.0, 1.0);
  const double deep = kShallow + (1.0 - kShallow) * t * t * (3.0 - 2.0 * t);
  return kHollow * deep * std::min(1.0, end.holds / kHoldsAll);
}

/// A wide closed end is what a vessel stands on.
double stands(const EndSigns& end) { return end.radius * (1.0 - end.depth); }

double by_file(Vec3 up) {
  const double x = std::abs(up.x), y = std::abs(up.y), z = std::abs(up.z);
  const bool on_y = y >= z && y >= x, on_z = !on_y && z >= x;
  const double most = on_y ? y : on_z ? z : x;
  const double worth = most < kAligned ? kAskew : on_y ? 1.0 : on_z ? kOnZ : kOnX;
  return (on_y ? up.y : on_z ? up.z : up.x) < 0.0 ? -worth : worth;
}

/// How low the middle of the surface lies between the body's ends, -1..1.
double by_mass(const Slicer& slicer, const BodyEnds& body) {
  double sum = 0.0, area = 0.0;
  for (const auto& t : slicer.mesh().triangles) {
    const Vec2 a = slicer.plane(t[0]), b = slicer.plane(t[1]), c = slicer.plane(t[2]);
    const double ha = slicer.height(t[0]), hb = slicer.height(t[1]), hc = slicer.height(t[2]);
    const Vec3 u{b.x - a.x, hb - ha, b.y - a.y}, v{c.x - a.x, hc - ha, c.y - a.y};
    const double size = length(cross(u, v));
    sum += size * (ha + hb + hc) / 3.0;
    area += size;
  }
  if (!(area > 0.0)) return 0.0;
  const double middle = (sum / area - body.bottom) / (body.top - body.bottom);
  return std::clamp(1.0 - 2.0 * middle, -1.0, 1.0);
}

}  // namespace

UpChoice weigh(const UpSigns& s) {
  const std::array<std::pair<UpFrom, double>, 5> votes{{
      {UpFrom::opening, hollow(s.above) - hollow(s.below)},
      {UpFrom::file, kFile * s.file},
      {UpFrom::foot, kStands * (stands(s.below) - stands(s.above))},
      {UpFrom::handles, kHandles * s.handles},
      {UpFrom::mass, kMass * s.mass},
  }};
  double sum = 0.0;
  for (const auto& [from, vote] : votes) sum += vote;
  UpChoice choice;
  choice.turn = sum < 0.0;
  choice.sure = 1.0 / (1.0 + portable::exp(-std::abs(sum)));
  double most = -1.0;
  for (const auto& [from, vote] : votes)
    if (const double for_it = choice.turn ? -vote : vote; for_it > most) {
      most = for_it;
      choice.from = from;
    }
  return choice;
}

Standing stand_upright(const TriangleMesh& mesh, const AxisFrame& frame, const BodyEnds& body,
                       const std::optional<Vec3>& given, RayCrossings& rays) {
  const Slicer slicer(mesh, frame);
  const double height = body.top - body.bottom, inset = 0.004 * height;
  std::vector<double> heights{body.bottom + inset};
  for (int i = 0; i < kUpSlices; ++i)
    heights.push_back(body.bottom + height * (i + 0.5) / kUpSlices);
  heights.push_back(body.top - inset);
  const auto slices = read_walls(slicer, heights, rays, body.size, body.facing_known);

  const auto radius_of = [&](const WallSlice& end) {
    return end.outer > 0.0 ? end.outer : 0.3 * body.size;
  };
  Standing out;
  const double over = radius_of(slices.back()), under = radius_of(slices.front());
  out.mouth = look_into(slicer, body.bottom, body.top, over, true);
  out.base = look_into(slicer, body.bottom, body.top, under, false);

  const auto signs_of = [&](const EndView& view, double radius, bool from_top) {
    EndSigns end;
    end.depth = std::clamp(view.floor / height, 0.0, 1.0);
    end.radius = std::min(1.0, radius / body.size);
    // At least what was looked into through the end itself; a belly behind a neck holds more.
    const double seen = view.openness * end.radius * end.radius;
    double volume = 0.0;
    for (int i = 0; i < kUpSlices; ++i) {
      const double t = (i + 0.5) / kUpSlices;
      const double inner = slices[static_cast<std::size_t>(i) + 1].inner / body.size;
      if ((from_top ? 1.0 - t : t) < end.depth) volume += inner * inner / kUpSlices;
    }
    end.holds = std::clamp(std::max(seen, view.openness > 0.0 ? volume : 0.0), 0.0, 1.0);
    if (body.facing_known) end.holds *= 1.0 - (1.0 - kBehind) * view.behind;
    return end;
  };
  UpSigns signs;
  signs.above = signs_of(out.mouth, over, true);
  signs.below = signs_of(out.base, under, false);
  signs.file = by_file(frame.up);
  double off = 0.0, high = 0.0;
  for (int i = 0; i < kUpSlices; ++i) {
    const double masked = slices[static_cast<std::size_t>(i) + 1].masked;
    off += masked;
    high += masked * (2.0 * (i + 0.5) / kUpSlices - 1.0);
  }
  const double share = off / (kUpSlices * static_cast<double>(rays.fan().count()));
  if (off > 0.0) signs.handles = high / off * std::min(1.0, share / kHandled);
  signs.mass = by_mass(slicer, body);
  out.choice = weigh(signs);
  if (given) {
    const double along = dot(*given, frame.up);
    // Across the axis it would turn by what little the axis leans: no word at all.
    if (std::abs(along) > kAlong * length(*given)) out.choice = {along < 0.0, 1.0, UpFrom::given};
  }

  out.frame = frame;
  out.body = body;
  if (!out.choice.turn) return out;
  out.frame = axis_frame(frame.origin, -frame.up);
  out.body.bottom = -body.top;
  out.body.top = -body.bottom;
  std::swap(out.mouth, out.base);
  return out;
}

std::string axis_name(Vec3 d) {
  const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  const bool on_y = y >= z && y >= x, on_z = !on_y && z >= x;
  const double along = on_y ? d.y : on_z ? d.z : d.x;
  return std::string(along < 0.0 ? "-" : "") + (on_y ? "y" : on_z ? "z" : "x");
}

}  // namespace onggi::extraction
