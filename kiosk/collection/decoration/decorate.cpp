#include "kiosk/collection/decoration/decorate.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/surface/laws.h"
#include "kiosk/collection/decoration/figure.h"
#include "kiosk/collection/decoration/way.h"

namespace onggi::decoration {

namespace {

using namespace surface;

constexpr double kThinnestLine = 5e-4;     // m: thinner ones vanish on a pot of the wheel's size
constexpr double kShallowestCut = 1.5e-4;  // m

class Hand {
 public:
  Hand(const Surface& surface, double scale) : surface_(surface), scale_(scale) {
    lip_ = lip_of(surface);
    end_ = surface.rows() * kRowHeight;
  }

  std::vector<Stroke> strokes(const Step& step) const {
    switch (step.kind) {
      case Step::coat:
        return {{coat(step), {}, false}};
      case Step::band:
        return {{brush(step), ring(along(step, step.at)), false}};
      case Step::smoke:
        return {{smoke(step), {}, false}};
      case Step::coil:
        return {{coil(step), ring(along(step, step.at)), false}};
      case Step::stamp:
        return {stamped(step)};
      case Step::burnish:
        return step.zone ? polish(step) : figures(step);
      default:
        return figures(step);
    }
  }

 private:
  /// m along the outline of a share of a side.
  double along(const Step& step, double share) const {
    return 1e-6 * (step.inside ? end_ - share * (end_ - lip_) : share * lip_);
  }
  double wide(double width) const { return std::max(width * scale_, kThinnestLine); }

  DipDef coat(const Step& step) const {
    DipDef def;
    def.coat = step.pigment == kGlaze ? DipDef::kGlaze : step.pigment;
    def.from = std::min(along(step, step.from), along(step, step.to));
    def.to = std::max(along(step, step.from), along(step, step.to));
    def.seconds = 1.0;
    def.rate = step.thickness;
    def.drinks = 1.0;
    return def;
  }

  BrushDef brush(const Step& step) const {
    BrushDef def;
    def.pigment = step.pigment;
    def.width = std::min(wide(step.width), 0.04);
    def.thickness = step.thickness;
    def.fill = step.fill;
    def.reach = step.load > 0.0 ? std::clamp(step.load * scale_, 0.01, kEndlessWay) : kEndlessWay;
    def.drags = 0.0;  // each step has dried before the next one
    return def;
  }

  SmokeDef smoke(const Step& step) const {
    SmokeDef def;
    def.from = along(step, step.from);
    def.soft = std::clamp(step.soft * scale_, 0.001, 0.05);
    def.wander = std::clamp(step.wander * scale_, 0.0, 0.05);
    def.seed = step.seed;
    return def;
  }

  CoilDef coil(const Step& step) const {
    CoilDef def;
    def.marks = step.marks;
    def.width = std::clamp(step.width * scale_, 0.002, 0.015);
    def.height = std::min(step.height * scale_, 0.003);
    return def;
  }

  Stroke stamped(const Step& step) const {
    StampDef def;
    def.side = kStampSide;
    def.depth = std::clamp(step.depth * scale_, kShallowestCut, 0.001);
    return stamp_stroke(def, step.motif, std::clamp(step.size * scale_, 0.001, 0.03),
                        along(step, step.at), step.turn, step.inside);
  }

  /// The stone goes round and round, up the zone.
  std::vector<Stroke> polish(const Step& step) const {
    BurnishDef def;
    std::vector<Stroke> out;
    const double low = std::min(along(step, step.from), along(step, step.to));
    const double high = std::max(along(step, step.from), along(step, step.to));
    for (double at = low + 0.5 * def.width; at < high; at += def.width)
      out.push_back({def, ring(at), !out.empty()});
    return out;
  }

  std::vector<Station> ring(double along) const {
    return way_of(surface_, {{0.0, 0.0}, {1.0, 0.0}}, {along, 0.0, 1.0, 1.0}, false);
  }

  /// What follows a line of a figure.
  Tool line_tool(const Step& step) const {
    switch (step.kind) {
      case Step::wipe: {
        WipeDef def;
        def.width = std::clamp(step.width * scale_, 0.002, 0.03);
        return def;
      }
      case Step::resist: {
        ResistDef def;
        def.width = std::clamp(step.width * scale_, 0.001, 0.03);
        return def;
      }
      case Step::scrape: {
        ScrapeDef def;
        def.width = std::clamp(step.width * scale_, 0.001, 0.04);
        return def;
      }
      case Step::burnish: {
        BurnishDef def;
        def.width = std::clamp(step.width * scale_, 0.001, 0.02);
        return def;
      }
      case Step::cut: {
        CutDef def;
        def.section = step.section;
        def.width = std::min(wide(step.width), 0.01);
        def.depth = std::clamp(step.depth * scale_, kShallowestCut, 0.003);
        def.teeth = step.teeth;
        def.spacing = std::clamp(step.spacing * scale_, 5e-4, 0.006);
        def.burr = 0.0;  // brushed off
        return def;
      }
      default:
        return brush(step);
    }
  }

  std::vector<Stroke> figures(const Step& step) const {
    const double at = along(step, step.at);
    const Tool tool = line_tool(step);
    std::optional<FillDef> fill;
    if (step.kind == Step::paint) {
      fill.emplace();
      fill->pigment = step.pigment;
      fill->thickness = step.thickness;
    }
    auto out = figure_strokes(
        surface_, step.motif,
        figure_place(surface_, at, step.turn, step.size * scale_, step.inside), tool, fill);
    if (out.empty()) out.push_back({tool, ring(at), false});
    return out;
  }

  const Surface& surface_;
  double scale_;
  int lip_ = 0, end_ = 0;
};

Result<void> do_step(Surface& surface, const Hand& hand, const Step& step) {
  for (const Stroke& stroke : hand.strokes(step)) {
    const auto all = repeated(stroke, step.repeat);
    if (!all) return tl::unexpected<Problem>(all.error());
    for (const Stroke& each : *all)
      if (const auto work = apply(surface, each); !work)
        return tl::unexpected<Problem>(work.error());
  }
  return {};
}

}  // namespace

double wheel_scale(const Profile& profile) {
  return std::min(1.0, kWheelHeight / profile.height());
}

int lip_of(const Surface& surface) {
  int first = 0, last = 0;
  for (int j = 0; j < surface.rows(); ++j) {
    if (surface.row(j).part == Part::outside) first = j + 1;
    if (surface.row(j).part <= Part::lip) last = j + 1;
  }
  return (first + last) * kRowHeight / 2;
}

Result<Surface> decorated(const Profile& profile, const Decoration& decoration,
                          const std::string& name) {
  const double scale = wheel_scale(profile);
  Result<Surface> surface = Surface::create(scaled(profile, scale), name);
  if (!surface) return surface;
  const Hand hand(*surface, scale);
  for (std::size_t n = 0; n < decoration.steps.size(); ++n)
    if (const auto done = do_step(*surface, hand, decoration.steps[n]); !done) {
      Problem problem = done.error();
      problem.where = name + ", step " + std::to_string(n + 1) + ", " + problem.where;
      return tl::unexpected<Problem>(std::move(problem));
    }
  return surface;
}

}  // namespace onggi::decoration
