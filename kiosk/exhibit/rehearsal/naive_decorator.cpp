#include "kiosk/exhibit/rehearsal/naive_decorator.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace onggi::rehearsal {

using decorating::DecoratedPot;
using decoration::WayTool;

namespace {

constexpr double kFacingEye = 1.5707963267948966;  // rad
constexpr double kAside = 0.9;                     // rad from there: they see no more
constexpr int kWhos = 5;
constexpr int kWithOneTool = 5;  // strokes until they take another
constexpr double kUndoes = 0.06, kChooses = 0.3;

}  // namespace

NaiveDecorator::NaiveDecorator(std::uint64_t seed, double seconds)
    : random_(seed * 0x9e3779b97f4a7c15ULL + 7),
      who_(static_cast<Who>(seed % kWhos)),
      seconds_(seconds) {}

std::string NaiveDecorator::choice(const DecoratedPot& pot) {
  // They do not look behind More tools.
  std::vector<int> shown;
  for (int n = 0; n < static_cast<int>(pot.way().tools.size()); ++n)
    if (!pot.way().tools[static_cast<std::size_t>(n)].more) shown.push_back(n);
  const auto tools = static_cast<int>(shown.size());
  const auto one_of = [&](int count) {
    return std::min(static_cast<int>(random_.uniform() * count), count - 1);
  };
  const auto tool = [&](int n) { return "decorate.tool." + std::to_string(n); };
  const auto any = [&] { return shown[static_cast<std::size_t>(one_of(tools))]; };
  if (who_ == Who::one_tool) {
    if (only_ < 0) {
      do only_ = any();
      while (pot.waits(only_));
      return tool(only_);
    }
  } else if (pot.waits(pot.tool())) {
    return tool(pot.held().needs);  // the screen says which comes first
  } else if (who_ == Who::all_tools) {
    if (strokes_ >= kWithOneTool || (strokes_ > 0 && pot.held().hand == WayTool::all)) {
      strokes_ = 0;
      const auto held = std::ranges::find(shown, pot.tool());
      return tool(held == shown.end() || held + 1 == shown.end() ? shown.front() : held[1]);
    }
  } else if (strokes_ >= 1 + one_of(kWithOneTool) ||
             (strokes_ > 0 && pot.held().hand == WayTool::all)) {
    strokes_ = 0;
    return tool(any());
  }
  if (random_.uniform() > kChooses) return {};
  const WayTool& held = pot.held();
  switch (one_of(3)) {
    case 0:
      if (held.pigments.size() > 1)
        return "decorate.color." + std::to_string(one_of(static_cast<int>(held.pigments.size())));
      break;
    case 1:
      if (held.motifs.size() > 1)
        return "decorate.figure." + std::to_string(one_of(static_cast<int>(held.motifs.size())));
      break;
    default:
      if (held.hand == WayTool::line || held.hand == WayTool::figure)
        return "decorate.times." + std::to_string(decoration::kRepeats[one_of(4)]);
  }
  return {};
}

void NaiveDecorator::begin_stroke(double now, const DecoratedPot& pot, const view::Camera& camera) {
  const auto& surface = pot.surface();
  const double share = random_.uniform(0.03, 0.98);
  const int row = std::clamp(static_cast<int>(share * pot.outside() * 1e6) / surface::kRowHeight, 0,
                             surface.rows() - 1);
  const double angle = kFacingEye - camera.azimuth + random_.uniform(-kAside, kAside);
  const double r = surface.row(row).radius;
  const auto from =
      camera.project({r * std::cos(angle), surface.row(row).height, r * std::sin(angle)});
  if (!from) return;
  at_ = {from->first, from->second};
  const bool tap = random_.uniform() < (who_ == Who::taps ? 0.85 : 0.15);
  const bool ring = pot.held().hand == WayTool::ring;
  const double quick =
      who_ == Who::scribbles ? random_.uniform(400, 1600) : std::exp(random_.uniform(3.5, 6.5));
  const double pixels = tap ? 0.0 : (ring ? 0.1 : 1.0) * quick * camera.height / 720.0;
  const double way = random_.uniform(0.0, 4 * kFacingEye);
  speed_ = {pixels * std::cos(way), pixels * std::sin(way)};
  bend_ = random_.uniform(-6.0, 6.0);
  shake_ = random_.uniform(0.3, 3.0) * camera.height / 720.0;
  until_ = now + (tap    ? random_.uniform(0.03, 0.15)
                  : ring ? random_.uniform(0.2, 3.5)
                         : random_.uniform(0.15, 2.0));
  down_ = true;
  ++strokes_;
}

DecoratingHand::Act NaiveDecorator::step(double now, const DecoratedPot& pot,
                                         const view::Camera& camera) {
  if (begun_ < 0) {
    begun_ = last_ = now;
    free_at_ = now + random_.uniform(0.5, 2.5);
  }
  const double dt = std::clamp(now - last_, 0.0, 0.1);
  last_ = now;
  if (down_) {
    if (now >= until_) {
      down_ = false;
      free_at_ = now + random_.uniform(0.1, 1.2);
      return {};
    }
    // It bends all the way, and turns about when it is far off: they come back to the pot.
    const double turn = bend_ * dt, c = std::cos(turn), s = std::sin(turn);
    speed_ = {c * speed_.first - s * speed_.second, s * speed_.first + c * speed_.second};
    at_.first += speed_.first * dt;
    at_.second += speed_.second * dt;
    const auto shaken = [&](double x) {
      return static_cast<float>(x + shake_ * random_.uniform(-1.0, 1.0));
    };
    return {"", std::pair{shaken(at_.first), shaken(at_.second)}};
  }
  if (now - begun_ > seconds_) {
    done_ = true;
    return {};
  }
  if (now < free_at_) return {};
  if (pot.can_undo() && random_.uniform() < kUndoes) {
    free_at_ = now + 0.5;
    return {"decorate.undo", {}};
  }
  if (std::string control = choice(pot); !control.empty()) {
    free_at_ = now + 0.4;
    return {std::move(control), {}};
  }
  begin_stroke(now, pot, camera);
  return {};
}

}  // namespace onggi::rehearsal
