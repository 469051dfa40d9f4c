#include "kiosk/visit/decorating/decorated_pot.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "kiosk/collection/decoration/decorate.h"
#include "kiosk/collection/decoration/figure.h"
#include "kiosk/visit/decorating/beaten_wall.h"
#include "kiosk/visit/decorating/calm_line.h"
#include "kiosk/visit/decorating/covering.h"
#include "kiosk/visit/decorating/figure_on_pot.h"

namespace onggi::decorating {

namespace {

using decoration::WayTool;
using surface::kRowHeight;
using surface::kSectors;
using surface::Station;

constexpr double kPiecesASecond = 40.0;                // of work that goes on by itself
constexpr double kHurry = 10.0;                        // times as fast, if a finger waits
constexpr std::size_t kPiece = 24;                     // stations: 12 mm
constexpr double kDab = 0.002;                         // m, of a finger that only tapped
constexpr double kShortStroke = 0.012;                 // m up and down from a button's place
constexpr double kMovedFigure = 0.0015;                // m, of a finger that carries a figure
constexpr double kTurnAngle = 2.0 * 3.14159265358979;  // rad
constexpr int kTilesAFrame = 40;                       // some 7 ms
constexpr int kMost = 1 << 20;
constexpr std::int64_t kMeltAFrame = 500'000;  // cells, some 6 ms; a tall pot needs 80 frames

constexpr double kSameHeight = 0.004;  // m: two dips that nobody tells apart
constexpr double kNarrow = 0.008;  // m to either side of a ring: of a wiped one only its bare part

/// True if what it changes is in its surface::Work: it lays something, or takes something away.
bool counts_its_work(const surface::Tool& law) {
  return std::holds_alternative<surface::CutDef>(law) ||
         std::holds_alternative<surface::BrushDef>(law) ||
         std::holds_alternative<surface::ScrapeDef>(law) ||
         std::holds_alternative<surface::DipDef>(law) ||
         std::holds_alternative<surface::FillDef>(law) ||
         std::holds_alternative<surface::CoilDef>(law);
}

bool lays_coat(const surface::Tool& law) {
  return std::holds_alternative<surface::BrushDef>(law) ||
         std::holds_alternative<surface::DipDef>(law);
}

}  // namespace

Result<std::unique_ptr<DecoratedPot>> DecoratedPot::begin(const Profile& thrown,
                                                          const decoration::Way& way) {
  auto surface = surface::Surface::create(thrown, "the pot");
  if (!surface) return tl::unexpected<Problem>(surface.error());
  return std::unique_ptr<DecoratedPot>(new DecoratedPot(std::move(*surface), way));
}

Result<std::unique_ptr<DecoratedPot>> DecoratedPot::begin(const Profile& thrown,
                                                          const decoration::Way& way,
                                                          std::span<const Print> prints,
                                                          const PrintsDef& faces) {
  auto pot = begin(thrown, way);
  if (!pot) return pot;
  (*pot)->printed_ = print((*pot)->surface_, prints, faces);
  if (!(*pot)->printed_) return pot;
  (*pot)->picture_.touch_all();
  (*pot)->drawn_ = !(*pot)->picture_.draw((*pot)->surface_, kMost);
  return pot;
}

DecoratedPot::DecoratedPot(surface::Surface surface, const decoration::Way& way)
    : way_(way),
      surface_(std::move(surface)),
      picture_(surface_, way.palette),
      zones_(surface_, outside()) {
  choices_.resize(way.tools.size());
  double high = 0.0, wide = 0.0;
  for (int j = 0; j < surface_.rows(); ++j) {
    high = std::max(high, surface_.row(j).height);
    wide = std::max(wide, 2.0 * surface_.row(j).radius);
  }
  open_ = wide > high;
}

bool DecoratedPot::waits(int tool) const {
  const int needs = tool_at(tool).needs;
  return needs >= 0 && std::ranges::find(own_steps(), needs, &Step::tool) == own_steps().end();
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

double DecoratedPot::along_of(double share, bool inside) const {
  const double lip = outside(), end = end_of_outline();
  return inside ? end - share * (end - lip) : share * lip;
}

bool DecoratedPot::touched(double from, double to) const {
  const auto first = static_cast<int>(from * 1e6) / kRowHeight;
  const auto last = static_cast<int>(to * 1e6) / kRowHeight + 1;
  return std::ranges::any_of(own_steps(), [&](const Step& step) {
    const WayTool::Hand hand = tool_at(step.tool).hand;
    return hand != WayTool::all && hand != WayTool::up &&
           std::ranges::any_of(
               step.parts, [&](const Part& part) { return part.from < last && first < part.to; });
  });
}

surface::Tool DecoratedPot::law() const {
  surface::Tool law = held().law;
  if (held().pigments.empty()) return law;
  const int pigment = held().pigments[static_cast<std::size_t>(choice().pigment)];
  if (auto* brush = std::get_if<surface::BrushDef>(&law)) brush->pigment = pigment;
  if (auto* dip = std::get_if<surface::DipDef>(&law)) dip->coat = pigment;
  return law;
}

void DecoratedPot::apply(surface::Stroke stroke, int repeats) {
  firing_.cool(picture_);
  tell_age(stroke);
  auto all = surface::repeated(stroke, repeats);
  if (!all) return;
  const bool counted = counts_its_work(stroke.tool);
  bool done = false;
  for (surface::Stroke& each : *all) {
    each.continues = step_begun_;
    const auto work = surface::apply(surface_, each);
    if (!work) continue;  // beyond the end of the pot
    done = true;
    if (!step_begun_) {
      steps_.push_back({working_,
                        choices_[static_cast<std::size_t>(working_)].pigment,
                        last_.value_or(began_at_).along,
                        {},
                        {}});
      changed_ = false;
    }
    step_begun_ = true;
    changed_ = changed_ || !counted || *work != surface::Work{};
    steps_.back().parts.push_back(touched_part(surface_, each));
    touch({steps_.back().parts.back()});
    if (WetSlip::lays(each.tool)) wet_.lay(surface_, steps_.back().parts.back());
  }
  if (keeps_work_ && done) note(stroke, repeats);
}

void DecoratedPot::note(const surface::Stroke& stroke, int repeats) {
  HandWork& work = steps_.back().work;
  if (work.ways.empty()) {
    work.tool = working_;
    work.law = stroke.tool;
    work.repeats = repeats;
  }
  if (tool_at(working_).hand != WayTool::figure) work.go_on(stroke.stations);
}

void DecoratedPot::end_step() {
  if (!step_begun_ || pressed() || busy()) return;
  if (!changed_) take_back();
  step_begun_ = false;
}

bool DecoratedPot::just_coated(double along) const {
  const bool all = held().hand == WayTool::all;
  if (shows_example() || steps_.empty() || (!all && held().hand != WayTool::up)) return false;
  const Step& last = steps_.back();
  return lays_coat(held().law) && last.tool == tool_ && last.pigment == pigment() &&
         (all || std::abs(last.from - along) < kSameHeight);
}

/// Slip that an earlier step laid is wet for a while, and a brush takes some of it along.
void DecoratedPot::tell_age(surface::Stroke& stroke) {
  if (!WetSlip::lays(stroke.tool)) return;
  if (!step_begun_) under_ = laid_;
  laid_ = clock_;
  if (!std::holds_alternative<surface::BrushDef>(stroke.tool)) return;
  const double age = std::min(clock_ - under_, 3600.0);
  for (Station& at : stroke.stations) at.age = static_cast<std::uint32_t>(1e3 * age);
}

void DecoratedPot::touch(const std::vector<Part>& parts) {
  drawn_ = false;
  for (const Part& part : parts) picture_.touch(part.from, part.to, part.first, part.last);
}

void DecoratedPot::press(const Place& at) {
  if (busy() || waits(tool_) || just_coated(at.along)) return;
  step_begun_ = false;
  working_ = tool_;
  last_.reset();
  last_ = {held().hand == WayTool::ring ? ring_at(at.along) : at.along, at.turns};
  began_at_ = *last_;
  switch (held().hand) {
    case WayTool::line:
    case WayTool::ring:
      tracer_.emplace(surface_, way_of_load());
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

double DecoratedPot::ring_at(double along) const {
  // A blade or a stone goes up and down.
  if (std::holds_alternative<surface::ScrapeDef>(held().law) ||
      std::holds_alternative<surface::BurnishDef>(held().law))
    return along;
  // All others stay where they began: a slanting band is nobody's wish.
  if (last_) return began_at_.along;
  const double half = std::min(reach_of(held().law), kNarrow);
  return zones_.within(along, half, half);
}

void DecoratedPot::move(const Place& at) {
  if (!last_) return;
  const double before = last_->along;
  const double way = std::remainder(at.turns - last_->turns, 1.0);
  const auto carried = [&] {
    return std::hypot(at.along - before, way * kTurnAngle * row_at(before).radius) > kMovedFigure;
  };
  switch (held().hand) {
    case WayTool::line: {
      const CalmPart part =
          calm_part(traced_to_.value_or(*last_), *last_, at.along, way, row_at(before).radius);
      for (const surface::HandPlace& next : part.way) {
        last_ = next;
        trace();
      }
      last_ = part.tip;
      return;
    }
    case WayTool::ring:
      last_ = {ring_at(at.along), last_->turns + way};
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
      if (traced_ == 0)
        move({std::min(last_->along + kDab + kSlack, end_of_outline()), last_->turns});
      trace();
      tracer_->lift();
      trace();
    }
  }
  tracer_.reset();
  last_.reset();
  end_step();
}

void DecoratedPot::cancel() {
  if (!last_) return;
  waiting_.clear();
  tracer_.reset();
  last_.reset();
  if (step_begun_) take_back();
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
  wait_for(in_pieces(law(), tracer_->stations(), traced_ > 0 ? traced_ - 1 : 0, kPiece));
}

void DecoratedPot::wait_for(std::vector<surface::Stroke> strokes) {
  std::ranges::move(strokes, std::back_inserter(waiting_));
}

/// How far the brush in the hand goes, m: each touch is a fresh dip.
double DecoratedPot::way_of_load() const {
  const auto* brush = std::get_if<surface::BrushDef>(&held().law);
  return brush != nullptr ? brush->reach : decoration::kEndlessWay;
}

void DecoratedPot::set_figure(const Place& at) {
  const int figure = held().motifs[static_cast<std::size_t>(choice().figure)];
  FigureOnPot set =
      figure_on_pot(surface_, held(), law(), way_.figures[static_cast<std::size_t>(figure)].motif,
                    zones_, outside(), repeats(), at);
  for (surface::Stroke& stroke : set.strokes) apply(std::move(stroke), repeats());
  if (!keeps_work_ || !step_begun_) return;
  HandWork& work = steps_.back().work;
  work.law = law();
  work.figure = HandWork::Figure{figure, set.along, at.turns, set.size, set.inside};
}

void DecoratedPot::cover_all() {
  // A bowl is looked into.
  wait_for(covering(surface_, law(), open_ ? end_of_outline() : outside(), end_of_outline()));
}

void DecoratedPot::from_up(const Place& at) {
  surface::Tool tool = law();
  if (auto* dip = std::get_if<surface::DipDef>(&tool)) {
    dip->from = std::max(at.along, kBareFoot), dip->to = end_of_outline();
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

void DecoratedPot::update(double dt, bool hurry) {
  clock_ += dt;
  wet_.dry(dt);
  if (busy()) {
    due_ += dt * kPiecesASecond * (hurry ? kHurry : 1.0);
    for (; due_ >= 1.0 && busy(); due_ -= 1.0) {
      gone_ += static_cast<double>(waiting_.front().stations.size()) * surface::Tracer::kStationWay;
      apply(std::move(waiting_.front()), 1);
      waiting_.pop_front();
    }
    end_step();
  } else {
    due_ = 0.0;
  }
  speed_ = dt > 0.0 ? gone_ / dt : 0.0;
  gone_ = 0.0;
  if (firing_.go_on(kMeltAFrame)) show_fire();
  drawn_ = !picture_.draw(surface_, kTilesAFrame);
}

bool DecoratedPot::settled() const { return drawn_ && !pressed() && !busy() && !firing_.melts(); }

void DecoratedPot::end_work() {
  for (; busy(); waiting_.pop_front()) apply(std::move(waiting_.front()), 1);
  end_step();
}

void DecoratedPot::finish() {
  lift();
  end_work();
  if (firing_.fired()) {
    heat();
    firing_.end();
    show_fire();
  }
  drawn_ = !picture_.draw(surface_, kMost);
}

Firing::Pot DecoratedPot::for_the_fire() const {
  Firing::Pot pot;
  for (const Step& step : steps_) {
    const surface::Tool& law = tool_at(step.tool).law;
    const auto* dip = std::get_if<surface::DipDef>(&law);
    pot.polished = pot.polished || std::holds_alternative<surface::BurnishDef>(law);
    pot.glazed = pot.glazed || (dip != nullptr && dip->coat == surface::DipDef::kGlaze);
  }
  return pot;
}

void DecoratedPot::heat() { firing_.heat(surface_, for_the_fire()); }

void DecoratedPot::fire(bool fired, bool glassy) {
  firing_.set(fired, glassy);
  show_fire();
}

void DecoratedPot::show_fire() {
  firing_.show(picture_, for_the_fire());
  drawn_ = false;
}

void DecoratedPot::begin_example() {
  end_example();
  lift();
  end_work();
  saved_ = Saved{surface_, steps_, laid_, under_};
}

void DecoratedPot::end_example() {
  if (!saved_) return;
  firing_.cool(picture_);
  waiting_.clear();
  tracer_.reset();
  last_.reset();
  step_begun_ = false;
  // The undo may have forgotten steps of the visitor's for those of the example.
  const auto shown = steps_.begin() + static_cast<std::ptrdiff_t>(saved_->steps.size());
  for (auto step = shown; step != steps_.end(); ++step) touch(step->parts);
  surface_ = std::move(saved_->surface);
  steps_ = std::move(saved_->steps);
  laid_ = saved_->laid, under_ = saved_->under;
  saved_.reset();
}

void DecoratedPot::undo() {
  if (!can_undo()) return;
  tracer_.reset();
  last_.reset();
  take_back();
}

void DecoratedPot::take_back() {
  firing_.cool(picture_);
  surface_.undo();
  touch(steps_.back().parts);
  steps_.pop_back();
  step_begun_ = false;
}

Layers DecoratedPot::layers_at(const Place& at) const {
  const int j = std::clamp(static_cast<int>(at.along * 1e6) / kRowHeight, 0, surface_.rows() - 1);
  const int i = surface::wrapped(static_cast<std::int64_t>(std::floor(at.turns * kSectors)));
  return layers_on(surface_, j, i, firing_.glaze_at(surface_, j, i, for_the_fire()));
}

std::vector<HandWork> DecoratedPot::work() const {
  std::vector<HandWork> out;
  for (const Step& step : own_steps()) out.push_back(step.work);
  return out;
}

WayTool::State DecoratedPot::state() const {
  WayTool::State state = WayTool::soft;
  for (const Step& step : own_steps())
    state = std::max(state, tool_at(step.tool).state.value_or(state));
  return state;
}

std::vector<DecoratedPot::Did> DecoratedPot::did() const {
  std::vector<Did> out;
  for (const Step& step : own_steps()) {
    const auto found = std::ranges::find(out, step.tool, &Did::tool);
    if (found == out.end())
      out.push_back({step.tool, 1});
    else
      ++found->times;
  }
  return out;
}

}  // namespace onggi::decorating
