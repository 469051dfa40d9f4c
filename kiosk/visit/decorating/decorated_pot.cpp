#include "kiosk/visit/decorating/decorated_pot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kiosk/collection/decoration/decorate.h"
#include "kiosk/collection/decoration/figure.h"

namespace onggi::decorating {

namespace {

using decoration::WayTool;
using surface::floor_div;
using surface::kRowHeight;
using surface::kSectors;
using surface::Station;

constexpr double kPiecesASecond = 40.0;                // of work that goes on by itself
constexpr std::size_t kBroadPiece = 140;               // stations of a broad tool at once
constexpr std::size_t kPiece = 24;                     // stations: 12 mm
constexpr double kDab = 0.002;                         // m, of a finger that only tapped
constexpr double kShortStroke = 0.012;                 // m up and down from a button's place
constexpr double kMovedFigure = 0.0015;                // m, of a finger that carries a figure
constexpr double kOfItsRoom = 0.94;                    // of the way round from a figure to the next
constexpr double kTurnAngle = 2.0 * 3.14159265358979;  // rad
constexpr double kFoot = 0.005;   // m that no dip covers: glaze would stick to the shelf
constexpr int kSlices = 24;       // of a dip that rises
constexpr int kTilesAFrame = 40;  // some 7 ms
constexpr int kMost = 1 << 20;

/// How far from its stations a tool changes cells, m.
struct Reach {
  double operator()(const surface::CutDef& def) const {
    return 0.5 * (def.width + (def.teeth - 1) * def.spacing) + 0.002;
  }
  double operator()(const surface::WipeDef& def) const { return 2.0 * def.width; }
  double operator()(const surface::StampDef&) const { return 0.02; }
  double operator()(const surface::FillDef&) const { return 0.0; }
  double operator()(const surface::DipDef&) const { return 0.0; }
  double operator()(const surface::SmokeDef&) const { return 0.0; }
  double operator()(const auto& def) const { return 0.5 * def.width; }
};

double reach_of(const surface::Tool& tool) { return std::visit(Reach{}, tool) + 5e-4; }
}  // namespace

Result<std::unique_ptr<DecoratedPot>> DecoratedPot::begin(const Profile& thrown,
                                                          const decoration::Way& way) {
  auto surface = surface::Surface::create(thrown, "the pot");
  if (!surface) return tl::unexpected<Problem>(surface.error());
  return std::unique_ptr<DecoratedPot>(new DecoratedPot(std::move(*surface), way));
}

DecoratedPot::DecoratedPot(surface::Surface surface, const decoration::Way& way)
    : way_(way), surface_(std::move(surface)), picture_(surface_, way.palette) {
  for (const WayTool& tool : way.tools) {
    choices_.emplace_back();
    choices_.back().repeats = tool.repeats;
  }
  double high = 0.0, wide = 0.0;
  for (int j = 0; j < surface_.rows(); ++j) {
    high = std::max(high, surface_.row(j).height);
    wide = std::max(wide, 2.0 * surface_.row(j).radius);
  }
  open_ = wide > high;
}

bool DecoratedPot::waits(int tool) const {
  const int needs = tool_at(tool).needs;
  return needs >= 0 && std::ranges::find(steps_, needs, &Step::tool) == steps_.end();
}

void DecoratedPot::choose_tool(int tool) {
  lift();
  tool_ = tool;
}

const surface::Row& DecoratedPot::row_at(double along) const {
  return surface_.row(
      std::clamp(static_cast<int>(along * 1e6) / kRowHeight, 0, surface_.rows() - 1));
}

bool DecoratedPot::turns() const { return pressed() && held().hand == WayTool::ring; }

double DecoratedPot::end_of_outline() const { return 1e-6 * surface_.rows() * kRowHeight; }

double DecoratedPot::outside() const { return 1e-6 * decoration::lip_of(surface_); }

surface::Tool DecoratedPot::law() const {
  surface::Tool law = held().law;
  if (held().pigments.empty()) return law;
  const int pigment = held().pigments[static_cast<std::size_t>(choice().pigment)];
  if (auto* brush = std::get_if<surface::BrushDef>(&law)) brush->pigment = pigment;
  if (auto* dip = std::get_if<surface::DipDef>(&law)) dip->coat = pigment;
  return law;
}

void DecoratedPot::apply(surface::Stroke stroke, int repeats) {
  auto all = surface::repeated(stroke, repeats);
  if (!all) return;
  for (surface::Stroke& each : *all) {
    each.continues = step_begun_;
    if (!surface::apply(surface_, each)) continue;  // beyond the end of the pot
    if (!step_begun_) steps_.push_back({working_, {}});
    step_begun_ = true;
    touch(each);
  }
}

void DecoratedPot::touch(const surface::Stroke& stroke) {
  Part part{surface_.rows(), 0, 0, kSectors};
  if (const auto* dip = std::get_if<surface::DipDef>(&stroke.tool)) {
    part.from = static_cast<int>(dip->from * 1e6) / kRowHeight;
    part.to = static_cast<int>(dip->to * 1e6) / kRowHeight + 1;
  } else if (stroke.stations.empty()) {
    part.from = 0, part.to = surface_.rows();
  } else {
    const double reach = reach_of(stroke.tool);
    const auto rows = static_cast<int>(reach * 1e6) / kRowHeight + 1;
    part.first = kSectors * surface::kMostTurns, part.last = -part.first;
    for (const Station& at : stroke.stations) {
      const int row = std::clamp(at.along / kRowHeight, 0, surface_.rows() - 1);
      const auto sectors = static_cast<int>(
          std::min(reach * 1e9 / std::max(surface_.row(row).width, 1), 1.0 * kSectors));
      const auto sector = static_cast<int>(floor_div(at.round, surface::kParts));
      part.from = std::min(part.from, row - rows), part.to = std::max(part.to, row + rows + 1);
      part.first = std::min(part.first, sector - sectors - 1);
      part.last = std::max(part.last, sector + sectors + 2);
    }
  }
  picture_.touch(part.from, part.to, part.first, part.last);
  steps_.back().parts.push_back(part);
}

void DecoratedPot::press(const Place& at) {
  if (busy() || waits(tool_)) return;
  step_begun_ = false;
  working_ = tool_;
  last_ = {at.along, at.turns};
  began_at_ = *last_;
  switch (held().hand) {
    case WayTool::line:
    case WayTool::ring:
      tracer_.emplace(surface_, decoration::kEndlessWay);
      traced_ = 0;
      traced_to_.reset();
      return trace();
    case WayTool::figure:
      return set_figure(at);
    case WayTool::up:
      return from_up(at);
    case WayTool::all:
      return cover_all();
  }
}

void DecoratedPot::move(const Place& at) {
  if (!last_) return;
  const double before = last_->along;
  const double way = std::remainder(at.turns - last_->turns, 1.0);
  const auto carried = [&] {
    return std::hypot(at.along - before, way * kTurnAngle * row_at(before).radius) > kMovedFigure;
  };
  switch (held().hand) {
    case WayTool::line:
    case WayTool::ring:
      last_ = {at.along, last_->turns + way};
      return trace();
    case WayTool::figure:
    case WayTool::up:
      if (!carried()) return;
      last_ = {at.along, last_->turns + way};
      if (step_begun_) take_back();
      step_begun_ = false;
      return held().hand == WayTool::figure ? set_figure(at) : from_up(at);
    case WayTool::all:
      return;
  }
}

void DecoratedPot::lift() {
  if (!last_) return;
  if (tracer_) {
    if (held().hand == WayTool::ring) {
      close_ring();
    } else {
      // A tap leaves a dab.
      if (traced_ == 0) move({std::min(last_->along + kDab, end_of_outline()), last_->turns});
      tracer_->lift();
      trace();
    }
  }
  tracer_.reset();
  last_.reset();
}

void DecoratedPot::trace() {
  const surface::HandPlace before = traced_to_.value_or(*last_);
  gone_ += std::hypot(last_->along - before.along,
                      (last_->turns - before.turns) * kTurnAngle * row_at(last_->along).radius);
  traced_to_ = *last_;
  tracer_->go(*last_);
  const auto& stations = tracer_->stations();
  if (stations.size() < 2 || stations.size() == traced_) return;
  const std::size_t from = traced_ > 0 ? traced_ - 1 : 0;
  apply({law(), {stations.begin() + static_cast<std::ptrdiff_t>(from), stations.end()}, false},
        held().hand == WayTool::line ? repeats() : 1);
  traced_ = stations.size();
}

void DecoratedPot::close_ring() {
  const double gone = last_->turns - began_at_.turns;
  const double whole = gone < 0.0 ? -1.0 : 1.0;
  if (std::abs(gone) < 1.0) tracer_->go({began_at_.along, began_at_.turns + whole});
  tracer_->lift();
  wait_for(tracer_->stations(), traced_ > 0 ? traced_ - 1 : 0, kPiece);
}

void DecoratedPot::wait_for(const std::vector<Station>& stations, std::size_t from,
                            std::size_t piece) {
  for (std::size_t n = from; n + 1 < stations.size(); n += piece) {
    const std::size_t to = std::min(n + piece + 1, stations.size());
    waiting_.push_back({law(),
                        {stations.begin() + static_cast<std::ptrdiff_t>(n),
                         stations.begin() + static_cast<std::ptrdiff_t>(to)},
                        false});
  }
}

double DecoratedPot::size_at(const decoration::Motif& motif, const Place& at) const {
  double left = 0.0, right = 0.0;
  for (const auto* ways : {&motif.fills, &motif.lines})
    for (const auto& points : *ways)
      for (const Vec2& p : points) left = std::min(left, p.x), right = std::max(right, p.x);
  const double room = kTurnAngle * row_at(at.along).radius / repeats();
  return std::min(held().size, kOfItsRoom * room / std::max(right - left, 0.1));
}

void DecoratedPot::set_figure(const Place& at) {
  const WayTool& tool = held();
  const auto& figures = way_.figures;
  const auto& figure =
      figures[static_cast<std::size_t>(tool.motifs[static_cast<std::size_t>(choice().figure)])];
  std::optional<surface::FillDef> fill;
  if (const auto* brush = std::get_if<surface::BrushDef>(&tool.law)) {
    fill.emplace();
    fill->pigment = std::get<surface::BrushDef>(law()).pigment;
    fill->thickness = brush->thickness;
  }
  const bool inside = at.along > outside();
  for (surface::Stroke& stroke :
       decoration::figure_strokes(surface_, figure.motif,
                                  decoration::figure_place(surface_, at.along, at.turns,
                                                           size_at(figure.motif, at), inside),
                                  law(), fill))
    apply(std::move(stroke), repeats());
}

void DecoratedPot::cover_all() {
  const surface::Tool tool = law();
  if (const auto* whole = std::get_if<surface::DipDef>(&tool)) {
    const double end = end_of_outline();
    for (int n = 0; n < kSlices; ++n) {
      surface::DipDef dip = *whole;
      dip.from = kFoot + (end - kFoot) * n / kSlices;
      dip.to = n + 1 == kSlices ? end : kFoot + (end - kFoot) * (n + 1) / kSlices;
      if (dip.from < dip.to) waiting_.push_back({dip, {}, false});
    }
    return;
  }
  // A bowl is looked into.
  const double end = open_ ? end_of_outline() : outside();
  const double half = std::min(reach_of(tool), 0.5 * end);
  for (double at = half; at < end + 0.8 * half; at += 1.8 * half) {
    const double along = std::min(at, end - half);
    wait_for(decoration::way_of(surface_, {{0.0, 0.0}, {1.0, 0.0}}, {along, 0.0, 1.0, 1.0}, false),
             0, kBroadPiece);
  }
}

void DecoratedPot::from_up(const Place& at) {
  surface::Tool tool = law();
  if (auto* dip = std::get_if<surface::DipDef>(&tool)) {
    dip->from = std::max(at.along, kFoot), dip->to = end_of_outline();
    if (dip->from >= dip->to) return;
  }
  if (auto* smoke = std::get_if<surface::SmokeDef>(&tool)) {
    smoke->from = at.along;
    smoke->seed = static_cast<int>(steps_.size()) + 1;
  }
  apply({tool, {}, false}, 1);
}

void DecoratedPot::put(const Place& at) {
  if (busy() || waits(tool_)) return;
  if (held().hand == WayTool::line) {
    press({std::max(at.along - kShortStroke, 0.0), at.turns});
    move({std::min(at.along + kShortStroke, end_of_outline()), at.turns});
  } else {
    press(at);
  }
  lift();
}

void DecoratedPot::update(double dt) {
  if (busy()) {
    due_ += dt * kPiecesASecond;
    for (; due_ >= 1.0 && busy(); due_ -= 1.0) {
      gone_ += static_cast<double>(waiting_.front().stations.size()) * surface::Tracer::kStationWay;
      apply(std::move(waiting_.front()), 1);
      waiting_.pop_front();
    }
  } else {
    due_ = 0.0;
  }
  speed_ = dt > 0.0 ? gone_ / dt : 0.0;
  gone_ = 0.0;
  picture_.draw(surface_, kTilesAFrame);
}

void DecoratedPot::finish() {
  lift();
  for (; busy(); waiting_.pop_front()) apply(std::move(waiting_.front()), 1);
  picture_.draw(surface_, kMost);
}

void DecoratedPot::undo() {
  if (!can_undo()) return;
  tracer_.reset();
  last_.reset();
  take_back();
}

void DecoratedPot::take_back() {
  surface_.undo();
  for (const Part& part : steps_.back().parts)
    picture_.touch(part.from, part.to, part.first, part.last);
  steps_.pop_back();
  step_begun_ = false;
}

std::vector<DecoratedPot::Did> DecoratedPot::did() const {
  std::vector<Did> out;
  for (const Step& step : steps_) {
    const auto found = std::ranges::find(out, step.tool, &Did::tool);
    if (found == out.end())
      out.push_back({step.tool, 1});
    else
      ++found->times;
  }
  return out;
}

}  // namespace onggi::decorating
