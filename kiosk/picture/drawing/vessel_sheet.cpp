#include "kiosk/picture/drawing/vessel_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/profile/measures.h"
#include "engine/profile/slices.h"

namespace onggi::drawing {

namespace {

/// Surfaces further out than this share of the vessel's size stand off, as in the extraction.
constexpr double kStandsOff = 0.025;
/// An edge is drawn where the outline turns by more than this within a hundredth of the height.
constexpr double kEdgeCos = 0.90;  // 26 degrees
constexpr int kOutlineSamples = 200;

std::string text(const char* format, double value) {
  char out[64];
  std::snprintf(out, sizeof out, format, value);
  return out;
}

std::string count(std::size_t n) {
  std::string out = std::to_string(n);
  for (auto at = static_cast<int>(out.size()) - 3; at > 0; at -= 3)
    out.insert(static_cast<std::size_t>(at), ",");
  return out;
}

/// Where the surface that stands off lies, looking down on the vessel: towards it is to the right.
Vec2 aside(const TriangleMesh& mesh, const Profile& p, double off) {
  Vec2 sum;
  for (const auto& t : mesh.triangles) {
    Vec3 middle, corner[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& q = mesh.positions[t[k]];
      corner[k] = {q[0], q[1], q[2]};
      middle += corner[k] * (1.0 / 3.0);
    }
    const double r = std::sqrt(middle.x * middle.x + middle.z * middle.z);
    if (middle.y < 0.0 || middle.y > p.height() || r <= p.outer_at(middle.y) + off) continue;
    const double area = length(cross(corner[1] - corner[0], corner[2] - corner[0]));
    sum = sum + Vec2{middle.x, middle.z} * (area * (r - p.outer_at(middle.y)) / r);
  }
  const double size = length(sum);
  return size > 0.0 ? sum * (1.0 / size) : Vec2{1, 0};
}

/// `mesh` turned about y so that `right` points along +x.
TriangleMesh turned(const TriangleMesh& mesh, Vec2 right) {
  TriangleMesh out = mesh;
  const auto turn = [&](std::array<float, 3>& v) {
    const double x = v[0], z = v[2];
    v[0] = static_cast<float>(right.x * x + right.y * z);
    v[2] = static_cast<float>(right.x * z - right.y * x);
  };
  for (auto& p : out.positions) turn(p);
  for (auto& n : out.normals) turn(n);
  return out;
}

/// The mesh cut by the plane z = 0, left of the axis.
std::vector<std::array<Vec2, 2>> slice_left(const TriangleMesh& mesh) {
  std::vector<std::array<Vec2, 2>> out;
  extraction::AxisFrame frame;  // "heights" along z; across is x, along is y
  frame.up = {0, 0, 1};
  frame.across = {1, 0, 0};
  frame.along = {0, 1, 0};
  for (const extraction::CutSegment& s : extraction::Slicer(mesh, frame).cut(0.0))
    if (std::min(s.a.x, s.b.x) < 0.0) out.push_back({s.a, s.b});
  return out;
}

/// Heights where `radius` turns sharply, the sharpest of each neighbourhood.
template <class Radius>
std::vector<double> sharp_turns(double low, double high, const Radius& radius) {
  std::vector<double> out;
  const double step = (high - low) / kOutlineSamples;
  if (!(step > 0.0)) return out;
  std::vector<double> cosine(kOutlineSamples + 1, 1.0);
  for (int i = 2; i + 2 <= kOutlineSamples; ++i) {
    const double h = low + i * step;
    const Vec2 a{radius(h) - radius(h - 2 * step), 2 * step},
        b{radius(h + 2 * step) - radius(h), 2 * step};
    cosine[static_cast<std::size_t>(i)] = dot(a, b) / (length(a) * length(b));
  }
  for (int i = 3; i + 3 <= kOutlineSamples; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (cosine[at] >= kEdgeCos) continue;
    if (*std::min_element(cosine.begin() + i - 3, cosine.begin() + i + 4) == cosine[at] &&
        (out.empty() || low + i * step - out.back() > 3.5 * step))
      out.push_back(low + i * step);
  }
  return out;
}

void add_wall(VesselSheet& sheet, const ExtractedProfile& e) {
  const auto& points = e.profile.points;
  sheet.wall.push_back({0.0, 0.0});
  for (const ProfilePoint& p : points) {
    sheet.outer.push_back({p.outer, p.height});
    sheet.wall.push_back({p.outer, p.height});
  }
  double floor = points.back().height;
  for (std::size_t i = points.size(); i-- > 0 && points[i].inner > 0.0;) {
    sheet.wall.push_back({points[i].inner, points[i].height});
    floor = points[i].height;
  }
  sheet.wall.push_back({0.0, floor});
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].inner <= 0.0) continue;
    const bool seen = i < e.inner_seen.size() && e.inner_seen[i];
    auto& runs = seen ? sheet.inner_seen : sheet.inner_inferred;
    const bool goes_on = i > 0 && points[i - 1].inner > 0.0 && e.inner_seen[i - 1] == seen;
    if (!goes_on) runs.push_back({});
    runs.back().push_back({points[i].inner, points[i].height});
  }
}

/// The first height on the way from `from` to `to` at which the outer wall is `diameter` wide.
double place_of(const Profile& p, double diameter, double from, double to) {
  constexpr int kPlaces = 2000;
  for (int n = 0; n < kPlaces; ++n) {
    const double at = from + (to - from) * n / kPlaces;
    if (2.0 * p.outer_at(at) >= 0.9999 * diameter) return at;
  }
  return from;
}

}  // namespace

VesselSheet sheet_of(const content::Vessel& vessel) {
  VesselSheet sheet;
  const ExtractedProfile& e = vessel.extracted;
  const Profile& p = e.profile;
  const content::Label label = vessel.label("en");
  sheet.title = label.title;
  sheet.subtitle = label.culture;
  if (!label.date.empty()) sheet.subtitle += (sheet.subtitle.empty() ? "" : ", ") + label.date;
  if (sheet.subtitle.empty()) sheet.subtitle = vessel.file.filename().string();
  if (!vessel.node.empty()) sheet.subtitle += ", node “" + vessel.node + "”";

  const Dimensions d = dimensions(p);
  sheet.height = d.height;
  sheet.belly = d.belly;
  sheet.belly_height = d.belly_height;
  sheet.mouth = d.mouth;
  sheet.foot = d.foot;
  sheet.foot_height = place_of(p, d.foot, 0.0, d.height);
  sheet.mouth_height = place_of(p, d.mouth, d.height, 0.0);
  sheet.masked_fraction = e.masked_fraction;
  sheet.true_size = content::is_known(vessel.size_from);
  for (const std::string& warning : e.warnings)
    if (warning.rfind("Left out as", 0) != 0)  // already given in figures
      sheet.notes.push_back(warning);

  add_wall(sheet, e);
  sheet.edges = sharp_turns(0.0, p.height(), [&](double h) { return p.outer_at(h); });
  const double floor = p.floor_height();
  sheet.inner_edges =
      sharp_turns(floor + 0.02 * p.height(), p.height(), [&](double h) { return p.inner_at(h); });
  if (floor < p.height()) sheet.inner_edges.insert(sheet.inner_edges.begin(), floor);

  const double off = kStandsOff * std::max(p.max_radius(), 0.5 * p.height() * 0.2);
  for (const ProfilePoint& point : p.points)
    sheet.limit.push_back({point.outer + off, point.height});
  sheet.mesh = turned(vessel.mesh, aside(vessel.mesh, p, off));
  sheet.slice = slice_left(sheet.mesh);

  sheet.facts.push_back("Symmetry " + text("%.3f", e.symmetry) +
                        ", left out as handle, spout or damage " +
                        text("%.1f", 100.0 * e.masked_fraction) + " %");
  const char* inner = p.inner_wall == InnerWall::measured   ? "measured"
                      : p.inner_wall == InnerWall::inferred ? "inferred"
                                                            : "not known";
  sheet.facts.push_back("Inner wall " + std::string(inner) + ", " +
                        text("%.1f", 1000.0 * d.wall_mean) + " mm thick on average");
  sheet.up_sure = e.up_sure;
  sheet.up_doubted = e.up_sure < ExtractedProfile::kSureUp;
  sheet.facts.push_back(count(vessel.mesh.triangles.size()) + " triangles");
  sheet.credit = vessel.credit;
  if (!vessel.licence.empty()) sheet.credit += (sheet.credit.empty() ? "" : ". ") + vessel.licence;
  return sheet;
}

}  // namespace onggi::drawing
