#include "kiosk/visit/decorating/recorded.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/math/portable.h"
#include "kiosk/collection/decoration/figure.h"
#include "kiosk/collection/decoration/write_decoration.h"
#include "kiosk/visit/decorating/covering.h"

namespace onggi::decorating {

namespace {

using decoration::kept_length;
using decoration::kept_share;
using decoration::WayTool;
using toml::OutlinePoint;

constexpr double kMilli = 1e-3, kMicro = 1e-6;        // m
constexpr double kNear = 1e-4;                        // m, of a drawn line from the hand's way
constexpr double kLeastSize = 0.01, kMostSize = 1.0;  // m, of the real vessel
constexpr double kPointParts = 1e4;                   // of a motif's unit
constexpr double kLevel = 250.0;                      // um up or down, of a ring
constexpr double kOnce = 1.02;                        // turns of a ring that only closed
constexpr double kNarrowest = 0.01;                   // m: where angles tell little of a way

using HandWay = std::vector<surface::Station>;

bool is_ring(const HandWork& work) {
  if (work.ways.size() != 1 || work.repeats != 1) return false;
  const HandWay& way = work.ways.front();
  const auto [low, high] = std::ranges::minmax(way, {}, &surface::Station::along);
  const double turns =
      std::abs(static_cast<double>(way.back().round) - way.front().round) / surface::kTurn;
  return high.along - low.along <= kLevel && turns >= 0.999 && turns <= kOnce;
}

struct Flat {
  double x = 0.0, y = 0.0;
};

/// Which of `points` a line within `near` of them needs (Douglas and Peucker 1973).
std::vector<std::size_t> needed(const std::vector<Flat>& points, double near) {
  std::vector<bool> keep(points.size(), false);
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    const Flat a = points[from], b = points[to];
    const double dx = b.x - a.x, dy = b.y - a.y, long2 = dx * dx + dy * dy;
    double far = near;
    std::size_t at = from;
    for (std::size_t n = from + 1; n < to; ++n) {
      const double px = points[n].x - a.x, py = points[n].y - a.y;
      const double t = long2 > 0.0 ? std::clamp((px * dx + py * dy) / long2, 0.0, 1.0) : 0.0;
      const double off = std::hypot(px - t * dx, py - t * dy);
      if (off > far) far = off, at = n;
    }
    if (at == from) continue;
    keep[at] = true;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
  std::vector<std::size_t> out;
  for (std::size_t n = 0; n < keep.size(); ++n)
    if (keep[n]) out.push_back(n);
  return out;
}

class Recorder {
 public:
  Recorder(const DecoratedPot& pot, double scale) : pot_(pot), scale_(scale) {
    lip_ = pot.outside();
    end_ = 1e-6 * pot.surface().rows() * surface::kRowHeight;
  }

  decoration::Decoration take() {
    choose_pigments();
    for (const HandWork& work : pot_.work()) add(work);
    end_lines();
    return std::move(out_);
  }

 private:
  const decoration::WayTool& tool_of(const HandWork& work) const {
    return pot_.way().tools[static_cast<std::size_t>(work.tool)];
  }
  double real(double length) const { return kept_length(length / scale_, kMilli); }
  bool within(double along) const { return along > lip_; }
  double share(double along) const {
    return kept_share(
        std::clamp(within(along) ? (end_ - along) / (end_ - lip_) : along / lip_, 0.0, 1.0));
  }

  static int pigment_of(const surface::Tool& law) {
    if (const auto* brush = std::get_if<surface::BrushDef>(&law)) return brush->pigment;
    const auto* dip = std::get_if<surface::DipDef>(&law);
    return dip != nullptr && dip->coat != surface::DipDef::kGlaze ? dip->coat : -1;
  }

  /// Those that were taken, in the way's order.
  void choose_pigments() {
    const decoration::Way& way = pot_.way();
    places_.assign(way.pigments.size(), -1);
    for (const HandWork& work : pot_.work())
      if (const int taken = pigment_of(work.law); taken >= 0)
        places_[static_cast<std::size_t>(taken)] = 0;
    for (std::size_t n = 0; n < places_.size(); ++n) {
      if (places_[n] < 0) continue;
      places_[n] = static_cast<int>(out_.pigments.size());
      const auto& coat = way.palette.pigments[n];
      out_.pigments.push_back({way.pigments[n].id, coat.fired, kept_length(coat.hides, kMicro)});
    }
  }

  /// A step of this law with all but its place.
  decoration::Step begun(const HandWork& work) const {
    decoration::Step step;
    if (const auto words = tool_of(work).did.find("en"); words != tool_of(work).did.end())
      step.says = words->second;
    step.repeat = work.repeats;
    if (const int taken = pigment_of(work.law); taken >= 0)
      step.pigment = places_[static_cast<std::size_t>(taken)];
    std::visit([&](const auto& def) { take_law(step, def); }, work.law);
    return step;
  }
  void take_law(decoration::Step& step, const surface::BrushDef& def) const {
    step.kind = decoration::Step::paint;
    step.width = real(def.width);
    step.thickness = kept_length(def.thickness, kMicro);
    step.fill = kept_share(def.fill);
    if (def.reach < decoration::kEndlessWay) step.load = real(def.reach);
  }
  void take_law(decoration::Step& step, const surface::CutDef& def) const {
    step.kind = decoration::Step::cut;
    step.width = real(def.width);
    step.depth = real(def.depth);
    step.section = static_cast<surface::CutDef::Section>(def.section);
    step.teeth = def.teeth;
    step.spacing = real(def.spacing);
  }
  void take_law(decoration::Step& step, const surface::ScrapeDef& def) const {
    step.kind = decoration::Step::scrape;
    step.width = real(def.width);
  }
  void take_law(decoration::Step& step, const surface::WipeDef& def) const {
    step.kind = decoration::Step::wipe;
    step.width = real(def.width);
  }
  void take_law(decoration::Step& step, const surface::StampDef& def) const {
    step.kind = decoration::Step::stamp;
    step.depth = real(def.depth);
  }
  void take_law(decoration::Step& step, const surface::DipDef& def) const {
    step.kind = decoration::Step::coat;
    step.thickness = kept_length(def.rate * def.seconds, kMicro);
    if (def.coat == surface::DipDef::kGlaze) step.pigment = decoration::kGlaze;
  }
  void take_law(decoration::Step& step, const surface::ResistDef& def) const {
    step.kind = decoration::Step::resist;
    step.width = real(def.width);
  }
  void take_law(decoration::Step& step, const surface::BurnishDef& def) const {
    step.kind = decoration::Step::burnish;
    step.width = real(def.width);
  }
  void take_law(decoration::Step& step, const surface::SmokeDef& def) const {
    step.kind = decoration::Step::smoke;
    step.soft = real(def.soft);
    step.wander = real(def.wander);
    step.seed = def.seed;
  }
  void take_law(decoration::Step& step, const surface::CoilDef& def) const {
    step.kind = decoration::Step::coil;
    step.width = real(def.width);
    step.height = real(def.height);
    step.marks = def.marks;
  }
  /// No tool of a way is one: a brush fills its figures.
  void take_law(decoration::Step&, const surface::FillDef&) const {}

  void add(const HandWork& work) {
    const bool free =
        !work.ways.empty() && !is_ring(work) && !std::holds_alternative<surface::CoilDef>(work.law);
    if (free && goes_on(work)) return add_ways(work);
    end_lines();
    decoration::Step step = begun(work);
    if (free) {
      lines_ = std::move(step);
      first_ = work;
      return add_ways(work);
    }
    if (work.figure) return add_figure(*work.figure, std::move(step));
    if (const auto* dip = std::get_if<surface::DipDef>(&work.law))
      return add_coat(tool_of(work).hand == WayTool::all ? kBareFoot : dip->from, std::move(step));
    if (const auto* smoke = std::get_if<surface::SmokeDef>(&work.law)) {
      step.inside = within(smoke->from);
      step.from = share(smoke->from);
      return keep(std::move(step));
    }
    const double at = 1e-6 * work.ways.front().front().along;
    if (step.kind == decoration::Step::paint) step.kind = decoration::Step::band;
    step.inside = within(at);
    step.at = share(at);
    keep(std::move(step));
  }
  void keep(decoration::Step step) { out_.steps.push_back(std::move(step)); }

  /// From `from` along the outline to the middle of the floor.
  void add_coat(double from, decoration::Step step) {
    if (!within(from)) {
      step.from = share(from);
      step.to = 1.0;
      if (step.from < step.to) keep(step);
      step.says.clear();
    }
    step.inside = true;
    step.from = 0.0;
    step.to = within(from) ? share(from) : 1.0;
    if (step.from < step.to && end_ > lip_) keep(std::move(step));
  }

  void add_figure(const HandWork::Figure& figure, decoration::Step step) {
    step.motif = pot_.way().figures[static_cast<std::size_t>(figure.figure)].motif;
    step.inside = figure.inside;
    step.at = share(figure.along);
    step.turn = kept_share(figure.turns - std::floor(figure.turns));
    step.size = real(figure.size);
    keep(std::move(step));
  }

  /// The same tool, colour and repeats as the lines before: one motif more.
  bool goes_on(const HandWork& work) const {
    if (!lines_ || work.tool != first_.tool || work.repeats != first_.repeats) return false;
    const double at = 1e-6 * work.ways.front().front().along;
    return pigment_of(work.law) == pigment_of(first_.law) &&
           within(at) == within(1e-6 * first_.ways.front().front().along);
  }
  void add_ways(const HandWork& work) {
    for (const HandWay& way : work.ways)
      if (way.size() > 1) ways_.push_back(way);
  }

  void end_lines() {
    if (!lines_) return;
    decoration::Step step = std::move(*lines_);
    lines_.reset();
    const std::vector<HandWay> ways = std::exchange(ways_, {});
    if (ways.empty()) return;
    near_first(step, ways);
    Frame frame = frame_for(step, ways);
    decoration::Motif::Drawn drawn;
    for (const HandWay& way : ways) drawn.lines.push_back(points_of(way, frame));
    step.motif = decoration::motif_of("line", std::move(drawn));
    keep(std::move(step));
  }

  /// Turns of a station, near to those of the first way.
  double turns_of(const surface::Station& at, double shift) const {
    return static_cast<double>(at.round) / surface::kTurn + shift;
  }
  double shift_of(const HandWay& way) const {
    return std::floor(turns_of(first_station_, 0.0) - turns_of(way.front(), 0.0) + 0.5);
  }

  struct Frame {
    decoration::FigurePlace place;
    double radius = 0.0;  // m
  };

  void near_first(decoration::Step& step, const std::vector<HandWay>& ways) {
    first_station_ = ways.front().front();
    step.inside = within(1e-6 * first_station_.along);
  }

  /// Chooses at, turn and size of `step`.
  Frame frame_for(decoration::Step& step, const std::vector<HandWay>& ways) const {
    double low = 1e9, high = -1e9, left = 1e9, right = -1e9;
    for (const HandWay& way : ways)
      for (const surface::Station& at : way) {
        const double turns = turns_of(at, shift_of(way));
        low = std::min(low, 1e-6 * at.along), high = std::max(high, 1e-6 * at.along);
        left = std::min(left, turns), right = std::max(right, turns);
      }
    double middle = 0.5 * (low + high);
    // Near the floor's middle a motif would be narrow, and over the lip is the other side.
    if (radius_at(middle) < kNarrowest) middle = step.inside ? low : high;
    middle = step.inside ? std::max(middle, lip_) : std::min(middle, lip_);
    const double turned = 0.5 * (left + right);
    const double whole = std::floor(turned);
    const double side = step.inside ? (end_ - middle) / (end_ - lip_) : middle / lip_;
    step.at = kept_share(std::clamp(side, 0.0, 1.0));
    step.turn = kept_share(turned - whole);
    step.size = kept_length(std::clamp((high - low) / scale_, kLeastSize, kMostSize), kMilli);
    Frame frame;
    const double along = pot_.along_of(step.at, step.inside);
    frame.place = decoration::figure_place(pot_.surface(), along, whole + step.turn,
                                           step.size * scale_, step.inside);
    frame.radius = radius_at(along);
    return frame;
  }
  double radius_at(double along) const {
    const int row = static_cast<int>(along * 1e6) / surface::kRowHeight;
    return pot_.surface().row(std::clamp(row, 0, pot_.surface().rows() - 1)).radius;
  }

  decoration::Motif::Drawn::Way points_of(const HandWay& way, const Frame& frame) const {
    const double shift = shift_of(way);
    std::vector<Flat> flat;
    for (const surface::Station& at : way)
      flat.push_back({turns_of(at, shift) * 2.0 * portable::kPi * frame.radius, 1e-6 * at.along});
    double near = kNear;
    std::vector<std::size_t> kept = needed(flat, near);
    while (kept.size() > decoration::kMostPoints) kept = needed(flat, near *= 2.0);
    decoration::Motif::Drawn::Way out;
    for (const std::size_t n : kept)
      out.push_back({rounded((turns_of(way[n], shift) - frame.place.turns) / frame.place.round),
                     rounded((1e-6 * way[n].along - frame.place.along) / frame.place.up), true});
    return out;
  }
  static double rounded(double units) {
    return std::floor(units * kPointParts + 0.5) / kPointParts;
  }

  const DecoratedPot& pot_;
  double scale_, lip_ = 0.0, end_ = 0.0;
  decoration::Decoration out_;
  std::vector<int> places_;                ///< In out_.pigments, by the way's.
  std::optional<decoration::Step> lines_;  ///< To which lines are still added.
  HandWork first_;                         ///< With which it began.
  std::vector<HandWay> ways_;
  surface::Station first_station_;
};

}  // namespace

decoration::Decoration recorded(const DecoratedPot& pot, double scale) {
  return Recorder(pot, scale).take();
}

}  // namespace onggi::decorating
