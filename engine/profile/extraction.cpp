#include "engine/profile/extraction.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/profile/axis.h"
#include "engine/profile/ends.h"
#include "engine/profile/median.h"
#include "engine/profile/up.h"
#include "engine/profile/wall_slice.h"

namespace onggi {
namespace extraction {
namespace {

constexpr int kRays = 96;
/// What a body of revolution may have at the most: surface away from any circle about its axis, all
/// that is masked, what is missing or lies within the circle; and how true the rest must be.
struct Allowed {
  double cost, masked, lacking, symmetry;
};
constexpr Allowed kUsual{0.30, 0.25, 0.25, 0.0};
/// Upright in its file, a jug may have more handle and spout on what is else a true circle.
constexpr Allowed kWithHandles{1.0, 0.40, 0.05, 0.995};
/// A rim this far aside of the foot, of the largest radius, or as much longer than wide, is told.
constexpr double kSlanted = 0.04;
/// One looks through a tube where nothing stops this share of the looks.
constexpr double kTube = 0.5;
/// Less than this mean depth is a flat or domed end, not a mouth.
constexpr double kOpen = 0.03;
/// Surfaces further from the axis than this many times the body's radius are other objects.
constexpr double kFarAway = 3.0;
/// A ray that meets more surfaces than this on its way out is in no vessel.
constexpr int kMostSurfaces = 64;
/// A cavity shallower than this share of the height is a modelled mouth over a solid body.
constexpr double kDeepEnough = 0.5;

/// Looks along the axis for a floor under a lid go this far from it, of the largest radius.
constexpr double kOnAxis = 0.15;
/// A wall seen on less of its height than this is said to be.
constexpr double kAllSeen = 0.95;

/// Thickness of a wall that cannot be seen, over the body's largest radius.
constexpr double kInferredWall = 0.04;
/// A foot narrower than this share of the wall a hair above it is a flat one, domed.
constexpr double kDomed = 0.8, kHair = 0.006;

std::string percent(double share) {
  return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " %";
}

std::string words_of(UpFrom from) {
  switch (from) {
    case UpFrom::opening:
      return "the opening";
    case UpFrom::file:
      return "the file's own upright";
    case UpFrom::foot:
      return "the foot, wider than the other end";
    case UpFrom::handles:
      return "the handles";
    case UpFrom::mass:
      return "where most of it lies";
    case UpFrom::given:
      break;
  }
  return "what was given";
}

class Extractor {
 public:
  Extractor(const TriangleMesh& mesh, const ExtractionOptions& options, const std::string& name)
      : mesh_(mesh), options_(options), name_(name), fan_(kRays), rays_(fan_) {}
  Result<ExtractedProfile> run();

 private:
  Result<void> check_mesh() const;
  Result<void> find_body(const FoundAxis& axis);
  Result<ExtractedProfile> read_about(const FoundAxis& axis, const Allowed& allowed);
  void stand();
  void read_slices();
  Result<void> judge_roundness();
  void note_slant();
  void fill_gaps();
  void square_foot();
  double find_floor();
  void read_inside();
  tl::unexpected<Problem> not_round(const std::string& why) const {
    return problem(name_, "it is not a body of revolution: " + why,
                   "Choose a vessel thrown on a wheel, export one object alone, or cut off handles "
                   "and spouts in the modelling tool.");
  }
  void warn(std::string text) { out_.warnings.push_back(std::move(text)); }

  const TriangleMesh& mesh_;
  const ExtractionOptions& options_;
  const std::string& name_;
  RayFan fan_;
  RayCrossings rays_;
  Allowed allowed_ = kUsual;
  AxisFrame frame_;
  BodyEnds body_;
  std::vector<double> heights_;
  std::vector<WallSlice> slices_;
  EndView mouth_;
  bool tube_ = false;  // one looks through it
  ExtractedProfile out_;
};

Result<void> Extractor::check_mesh() const {
  if (mesh_.triangles.empty())
    return problem(name_, "it has no triangles.", "Export the vessel's surface.");
  for (const auto& t : mesh_.triangles)
    for (const std::uint32_t i : t)
      if (i >= mesh_.positions.size())
        return problem(name_, "a triangle names a vertex that is not there.",
                       "Export the vessel again.");
  double low = 1e300, high = -1e300;
  for (const auto& p : mesh_.positions)
    for (const float v : p) {
      if (!std::isfinite(v))
        return problem(name_, "a vertex has a position that is not a number.",
                       "Clean the mesh in the modelling tool and export again.");
      low = std::min<double>(low, v);
      high = std::max<double>(high, v);
    }
  if (!(high - low > 1e-9 * std::max(std::abs(high), std::abs(low))) || high - low < 1e-12)
    return problem(name_, "it has no size.",
                   "Apply the scale in the modelling tool, and export again.");
  return {};
}

Result<void> Extractor::find_body(const FoundAxis& axis) {
  if (axis.cost > allowed_.cost)
    return not_round("about its best axis " + percent(axis.cost) +
                     " of the surface lies away from a circle.");
  frame_ = axis_frame(axis.origin, axis.direction);
  const Slicer slicer(mesh_, frame_);
  body_ = find_ends(slicer, rays_);
  if (!(body_.top > body_.bottom) || body_.size <= 0.0)
    return not_round("no slice across its axis is a circle.");
  double furthest = 0.0;
  for (const auto& t : mesh_.triangles)
    for (const std::uint32_t i : t) furthest = std::max(furthest, length(slicer.plane(i)));
  if (furthest > kFarAway * body_.size)
    return not_round("its surfaces reach " + std::to_string(std::lround(furthest / body_.size)) +
                     " times as far from the axis as its wall. Perhaps the file holds several "
                     "objects.");
  return {};
}

void Extractor::stand() {
  const Standing found = stand_upright(mesh_, frame_, body_, options_.up, rays_);
  frame_ = found.frame;
  body_ = found.body;
  mouth_ = found.mouth;
  tube_ = found.mouth.through > kTube && found.base.through > kTube;
  out_.up_from = found.choice.from;
  out_.up_sure = found.choice.sure;
  if (options_.up && out_.up_from != UpFrom::given)
    warn("The given up, " + axis_name(*options_.up) + ", lies across the vessel's axis: " +
         axis_name(frame_.up) + " or " + axis_name(-frame_.up) + " would tell which end is up.");
  if (out_.up_sure >= ExtractedProfile::kSureUp) return;
  warn("It could be upside down. The direction comes from " + words_of(out_.up_from) + ", " +
       percent(out_.up_sure) + " sure. If the rim is at the other end, write up = \"" +
       axis_name(-frame_.up) + "\" in vessel.toml.");
}

void Extractor::read_slices() {
  const Slicer slicer(mesh_, frame_);
  const int n = std::clamp(options_.slices, 16, 2000);
  const double height = body_.top - body_.bottom;
  std::vector<double> cuts;
  for (int i = 0; i < n; ++i) {
    heights_.push_back(height * i / (n - 1));
    // A plane through a flat foot or rim meets nothing or everything; stay a hair inside.
    cuts.push_back(body_.bottom + std::clamp(heights_.back(), 0.001 * height, 0.999 * height));
  }
  slices_ = read_walls(slicer, cuts, rays_, body_.size, body_.facing_known);
}

Result<void> Extractor::judge_roundness() {
  double spread = 0.0, mean = 0.0, beyond = 0.0, lacking = 0.0;
  int round = 0;
  for (const WallSlice& s : slices_) {
    lacking += s.outer > 0.0 ? s.within + (kRays - s.present) : kRays;
    if (s.outer <= 0.0) continue;
    beyond += s.masked - s.within;
    spread += s.spread;
    mean += s.outer;
    ++round;
  }
  const auto n = static_cast<double>(slices_.size());
  beyond /= n * kRays;
  lacking /= n * kRays;
  out_.masked_fraction = beyond + lacking;
  out_.symmetry = std::clamp(1.0 - spread / mean, 0.0, 1.0);
  if (out_.masked_fraction > allowed_.masked || lacking > allowed_.lacking || round < 0.8 * n ||
      out_.symmetry < allowed_.symmetry)
    return not_round(percent(out_.masked_fraction) + " of it lies off the circle of the rest.");
  if (out_.masked_fraction > 0.01)
    warn("Left out as handle, spout or damage: " + percent(out_.masked_fraction) +
         " of the surface.");
  note_slant();
  return {};
}

/// Circles whose centres run aside, or that are all longer one way, come of a modelling tool.
void Extractor::note_slant() {
  const std::size_t n = slices_.size(), half = n / 2;
  std::vector<double> across, along, x, y;
  for (std::size_t i = 0; i < n; ++i) {
    if (slices_[i].outer <= 0.0) continue;
    x.push_back(slices_[i].oval.x);
    y.push_back(slices_[i].oval.y);
    if (i + half >= n || slices_[i + half].outer <= 0.0) continue;
    across.push_back(slices_[i + half].centre.x - slices_[i].centre.x);
    along.push_back(slices_[i + half].centre.y - slices_[i].centre.y);
  }
  if (across.empty()) return;
  const double lean = 2.0 * length(Vec2{median(across), median(along)}) / body_.size;
  const double oval = 2.0 * length(Vec2{median(x), median(y)}) / body_.size;
  if (std::max(lean, oval) < kSlanted) return;
  warn((lean > oval
            ? "It leans: its rim is " + percent(lean) +
                  " of its largest radius to the side of its foot."
            : "It is oval: longer than wide by " + percent(oval) + " of its largest radius.") +
       " If it was sheared or stretched in a modelling tool, undo that and export it again.");
}

/// A slice without a wall takes it from its neighbours.
void Extractor::fill_gaps() {
  const std::size_t n = slices_.size();
  std::size_t filled = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (slices_[i].outer > 0.0) continue;
    std::size_t above = i, below = i;
    while (above < n && slices_[above].outer <= 0.0) ++above;
    while (below > 0 && slices_[below].outer <= 0.0) --below;
    ++filled;
    if (above == n) {
      slices_[i].outer = slices_[below].outer;
    } else if (slices_[below].outer <= 0.0) {
      slices_[i].outer = slices_[above].outer;
    } else {
      const double t = static_cast<double>(i - below) / static_cast<double>(above - below);
      slices_[i].outer = slices_[below].outer + t * (slices_[above].outer - slices_[below].outer);
    }
  }
  if (filled > 0)
    warn("The wall is missing at " + std::to_string(filled) + " of " + std::to_string(n) +
         " heights; it is filled in from its neighbours.");
}

/// A flat foot that a rough or coarse mesh has domed by a hair would end in a point: the wall just
/// above it is drawn on down.
void Extractor::square_foot() {
  const auto reach = std::max<std::size_t>(
      2, static_cast<std::size_t>(std::ceil(kHair * static_cast<double>(slices_.size()))));
  if (2 * reach >= slices_.size()) return;
  const double near = slices_[reach].outer, far = slices_[2 * reach].outer;
  if (slices_[0].outer >= kDomed * near) return;
  const double slope = std::max(0.0, (far - near) / static_cast<double>(reach));
  for (std::size_t i = 0; i < reach; ++i)
    slices_[i].outer = std::max(slices_[i].outer, near - slope * static_cast<double>(reach - i));
}

/// Height of the floor above the foot; 0 where none is seen.
double Extractor::find_floor() {
  const std::size_t n = slices_.size();
  const double height = heights_.back();
  const bool open = mouth_.openness > kOpen;
  // A hollow that holds as much as all below it is worth is the inside, however tall the stem.
  const auto is_inside = [&](double floor) {
    double held = 0.0, below = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      if (heights_[i] <= floor)
        below += slices_[i].outer * slices_[i].outer;
      else
        held += slices_[i].inner * slices_[i].inner;
    return held > 0.0 && held >= below;
  };
  if (open) {
    const double floor = height - mouth_.floor;
    if (mouth_.floor >= kDeepEnough * height) return std::min(floor, kDeepEnough * height);
    if (is_inside(floor)) return floor;
    warn("The inside is modelled only " + percent(mouth_.floor / height) +
         " deep; below that the wall is a guess.");
    return 0.0;
  }
  warn("There is no opening at the top, so a lid or stopper is part of the outline.");
  if (!body_.facing_known) return 0.0;
  const Slicer slicer(mesh_, frame_);
  const Hollow hollow = find_hollow(slicer, body_.bottom, body_.top, kOnAxis * body_.size);
  const double floor = hollow.floor - body_.bottom;
  return hollow.ceiling > hollow.floor && is_inside(floor) ? floor : 0.0;
}

void Extractor::read_inside() {
  const std::size_t n = slices_.size();
  const double height = heights_.back();
  const double guess = kInferredWall * body_.size;
  const bool open = mouth_.openness > kOpen;
  if (tube_)
    warn("Both ends are open: it is a tube, and its base is taken as closed.");
  else if (mouth_.through > 0.02 && open)
    warn("There is a hole through the base; it is taken as closed.");
  double floor = find_floor();
  const bool closed = !open && floor > 0.0;  // a lid over a hollow that is there
  const double lowest = closed ? floor : open ? height - mouth_.floor : height;
  if (floor <= 0.0) floor = guess;

  // Thickness where both sides are seen; elsewhere the nearest seen one, or the guess.
  std::vector<double> thickness(n, 0.0), hollow(n, 0.0);
  std::size_t seen = 0, wanted = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (heights_[i] <= floor) continue;
    ++wanted;
    // Both sides of one wall, or it is not measured: behind a skirt lies air, and then the wall.
    if (heights_[i] <= lowest || slices_[i].inner <= 0.0) continue;
    hollow[i] = slices_[i].inner;
    if (!slices_[i].one_wall) continue;
    thickness[i] = slices_[i].outer - slices_[i].inner;
    ++seen;
  }
  const double share = wanted > 0 ? static_cast<double>(seen) / static_cast<double>(wanted) : 0.0;
  out_.profile.inner_wall = share >= 0.75 ? InnerWall::measured : InnerWall::inferred;
  if (share < kAllSeen)
    warn("Both sides of the wall are measured on " + percent(share) +
         " of the height; the rest is inferred.");

  for (std::size_t i = 0; i < n; ++i) {
    ProfilePoint p{heights_[i], slices_[i].outer, 0.0};
    if (heights_[i] > floor) {
      double t = thickness[i];
      for (std::size_t d = 1; t <= 0.0 && d < n; ++d) {
        // A seen thickness far away says little about this place.
        if (static_cast<double>(d) > 0.1 * static_cast<double>(n)) break;
        if (i + d < n && thickness[i + d] > 0.0) t = thickness[i + d];
        if (i >= d && t <= 0.0 && thickness[i - d] > 0.0) t = thickness[i - d];
      }
      if (t <= 0.0 && hollow[i] <= 0.0) {
        out_.inferred_wall = guess;
        // Across a leaning wall, the horizontal section is longer than the wall is thick.
        const std::size_t a = i > 0 ? i - 1 : i, b = std::min(i + 1, n - 1);
        const double lean = (slices_[b].outer - slices_[a].outer) / (heights_[b] - heights_[a]);
        t = guess * std::min(3.0, std::sqrt(1.0 + lean * lean));
      }
      p.inner = std::clamp(p.outer - t, 0.05 * p.outer, 0.98 * p.outer);
      if (hollow[i] > 0.0) p.inner = hollow[i];
    }
    out_.profile.points.push_back(p);
    out_.inner_seen.push_back(thickness[i] > 0.0);
  }
}

Result<ExtractedProfile> Extractor::read_about(const FoundAxis& axis, const Allowed& allowed) {
  allowed_ = allowed;
  out_ = {};
  heights_.clear();
  slices_.clear();
  if (auto good = find_body(axis); !good) return tl::unexpected<Problem>(good.error());
  stand();
  read_slices();
  if (auto good = judge_roundness(); !good) return tl::unexpected<Problem>(good.error());
  fill_gaps();
  square_foot();
  read_inside();
  out_.axis_direction = frame_.up;
  out_.axis_origin = frame_.origin + frame_.up * body_.bottom;
  if (auto good = validate(out_.profile, name_); !good)
    return tl::unexpected<Problem>(good.error());
  return std::move(out_);
}

Result<ExtractedProfile> Extractor::run() {
  if (auto good = check_mesh(); !good) return tl::unexpected<Problem>(good.error());
  if (const int met = surfaces_met(mesh_); met > kMostSurfaces)
    return not_round("a ray from its middle meets " + std::to_string(met) +
                     " surfaces; it is a heap of loose triangles.");
  auto found = read_about(find_axis(mesh_), kUsual);
  if (found) return found;
  // Wide handles can make another axis look better than the one a jug was thrown about.
  for (const Vec3& up : {Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    if (auto jug = read_about(axis_along(mesh_, up), kWithHandles)) return jug;
  return found;
}

}  // namespace
}  // namespace extraction

Result<ExtractedProfile> extract_profile(const TriangleMesh& mesh, const ExtractionOptions& options,
                                         const std::string& name) {
  return extraction::Extractor(mesh, options, name).run();
}

}  // namespace onggi
