#include "engine/lab/accuracy.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/contact/paper_model.h"
#include "engine/scene/scene.h"

namespace onggi::lab {
namespace {

using Forces = std::array<Vec3, kMaxHands>;
using Model = AccuracySetting::Model;

// Runs one tick after another, whichever model works the script.
class Worker {
 public:
  virtual ~Worker() = default;
  // Runs from `from` to `to` (s); returns the mean force on each ball.
  virtual Forces tick(double from, double to) = 0;
  virtual FaceGrid face(WallSide side) const = 0;
};

BallWay way_of(const AccuracyScript& script, std::size_t n, double from, double to) {
  return {script.balls[n].side,
          script.place(n, from),
          script.place(n, to),
          script.def.tool.radius,
          script.wheel_angle(from),
          script.wheel_angle(to),
          to - from};
}

template <class Real>
class PlainWorker final : public Worker {
 public:
  PlainWorker(const AccuracyScript& script, const ClayDef& grid, const PlainLaw& law, int substeps)
      : script_(script), law_(law), substeps_(substeps), wall_(grid, script.low, script.high) {}
  Forces tick(double from, double to) override {
    Forces sum{};
    for (int n = 0; n < substeps_; ++n) {
      const double begin = from + (to - from) * n / substeps_;
      const double end = from + (to - from) * (n + 1) / substeps_;
      for (std::size_t k = 0; k < script_.balls.size(); ++k)
        sum[k] += (1.0 / substeps_) * wall_.step(law_, way_of(script_, k, begin, end));
    }
    return sum;
  }
  FaceGrid face(WallSide side) const override { return face_of(wall_, side); }

 private:
  const AccuracyScript& script_;
  PlainLaw law_;
  int substeps_;
  PlainWall<Real> wall_;
};

class ShippedWorker final : public Worker {
 public:
  ShippedWorker(const AccuracyScript& script, const SceneDef& def, int substeps)
      : script_(script), substeps_(substeps), scene_(std::move(*Scene::create(def))) {}
  Forces tick(double from, double to) override {
    Forces sum{};
    for (int n = 0; n < substeps_; ++n) {
      const double end = from + (to - from) * (n + 1) / substeps_;
      const Feedback felt = scene_.step(script_.hands(end), (to - from) / substeps_);
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += (1.0 / substeps_) * felt.hand[k].force;
      angle_ = felt.clay_angle;
    }
    time_ = to;
    return sum;
  }
  FaceGrid face(WallSide side) const override {
    FaceGrid face = face_of(scene_.clay(), side, script_.low, script_.high);
    // In the first tick the wheel may have begun elsewhere.
    face.turned = angle_ - script_.wheel_angle(time_);
    return face;
  }

 private:
  const AccuracyScript& script_;
  int substeps_;
  Scene scene_;
  double angle_ = 0.0, time_ = 0.0;
};

// The printed model has one radius: it lies on the worked face.
ClayDef one_face(const AccuracyScript& script, ClayDef clay) {
  if (script.balls.front().side == WallSide::outside) return clay;
  clay.outer_radius = clay.inner_radius;
  clay.inner_radius = clay.radius_min = 0.001;
  clay.wall_min = 0.0005;
  return clay;
}

class PrintedWorker final : public Worker {
 public:
  PrintedWorker(const AccuracyScript& script, const ClayDef& grid, int substeps)
      : script_(script),
        substeps_(substeps),
        clay_(std::move(*Clay::create(one_face(script, grid)))),
        model_(clay_) {}
  Forces tick(double from, double to) override {
    const PaperDef usual;
    Forces sum{};
    for (int n = 0; n < substeps_; ++n) {
      const double end = from + (to - from) * (n + 1) / substeps_;
      for (std::size_t k = 0; k < script_.balls.size(); ++k)
        sum[k] += (1.0 / substeps_) * model_
                                          .tick(clay_, script_.balls[k].side, script_.place(k, end),
                                                script_.def.tool.radius, script_.wheel_angle(end),
                                                1.0, {usual.c_eta, usual.c_v, 0.0})
                                          .resistance;
    }
    return sum;
  }
  FaceGrid face(WallSide) const override {
    return face_of(clay_, WallSide::outside, script_.low, script_.high);
  }

 private:
  const AccuracyScript& script_;
  int substeps_;
  Clay clay_;
  PaperModel model_;
};

std::unique_ptr<Worker> worker_of(const AccuracyScript& script, const AccuracySetting& setting) {
  SceneDef def = script.def;
  def.clay.rows = setting.rows;
  def.clay.sectors = setting.sectors;
  if (setting.model == Model::shipped)
    return std::make_unique<ShippedWorker>(script, def, setting.substeps);
  if (setting.model == Model::printed)
    return std::make_unique<PrintedWorker>(script, def.clay, setting.substeps);
  const PlainLaw law{.rule = setting.rule,
                     .quadrature = setting.quadrature,
                     .relaxation_time = def.contact.relaxation_time,
                     .stiffness = def.contact.stiffness};
  if (setting.doubles)
    return std::make_unique<PlainWorker<double>>(script, def.clay, law, setting.substeps);
  return std::make_unique<PlainWorker<float>>(script, def.clay, law, setting.substeps);
}

// Forces as means of windows. A window is one tick or several.
struct Felt {
  std::vector<std::array<Vec3, 2>> windows;
  double mean(double least = 1e-6) const {
    double sum = 0.0;
    long count = 0;
    for (const auto& window : windows) {
      if (length(window[0]) <= least) continue;
      sum += length(window[0]);
      ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
  }
};

// Plays the script once; `each` runs a tick, and may time it.
template <class Each>
Felt play(const AccuracyScript& script, double rate, Each&& each) {
  Felt felt;
  const long ticks = std::lround(script.seconds * rate);
  const double per_window = kForceWindow * rate;
  Forces sum{};
  for (long n = 0; n < ticks; ++n) {
    const Forces force = each(n, static_cast<double>(n) / rate, static_cast<double>(n + 1) / rate);
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += (1.0 / per_window) * force[k];
    if ((n + 1) % std::lround(per_window) != 0) continue;
    felt.windows.push_back(sum);
    sum = {};
  }
  return felt;
}

double force_error(const Felt& felt, const Truth& truth) {
  double squares = 0.0;
  long count = 0;
  const std::size_t windows = std::min(felt.windows.size(), truth.force.size());
  for (std::size_t n = 0; n < windows; ++n)
    for (std::size_t k = 0; k < kMaxHands; ++k) {
      const Vec3 is = felt.windows[n][k], should = truth.force[n][k];
      if (dot(is, is) == 0.0 && dot(should, should) == 0.0) continue;
      const Vec3 off = is - should;
      squares += dot(off, off);
      ++count;
    }
  return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
}

double fresh_radius(const AccuracyScript& script, WallSide side) {
  return side == WallSide::outside ? script.def.clay.outer_radius : script.def.clay.inner_radius;
}

AccuracyErrors errors_of(const AccuracyScript& script, const Worker& worker, const Felt& felt,
                         const Truth& truth, double& displaced_volume) {
  AccuracyErrors out;
  double squares = 0.0;
  int faces = 0;
  displaced_volume = 0.0;
  for (const WallSide side : {WallSide::outside, WallSide::inside}) {
    if (!script.works(side)) continue;
    const FaceGrid face = worker.face(side);
    const FaceDifference off = difference(face, truth.face[side == WallSide::outside ? 0 : 1]);
    squares += off.rms * off.rms;
    ++faces;
    out.shape_max = std::max(out.shape_max, off.most);
    displaced_volume += displaced(face, fresh_radius(script, side));
  }
  out.shape_rms = std::sqrt(squares / faces);
  out.force_rms = force_error(felt, truth);
  out.volume = std::fabs(displaced_volume / truth.displaced - 1.0);
  return out;
}

}  // namespace

const char* name_of(Model model) {
  return model == Model::printed ? "printed" : model == Model::plain ? "plain" : "shipped";
}
const char* name_of(TimeRule rule) {
  return rule == TimeRule::printed ? "euler" : rule == TimeRule::exact ? "exact" : "middle";
}
const char* name_of(Quadrature quadrature) {
  return quadrature == Quadrature::none   ? "none"
         : quadrature == Quadrature::area ? "area"
                                          : "edges";
}

Truth truth_of(const AccuracyScript& script, const TruthPlan& plan) {
  AccuracySetting setting{.model = Model::plain, .doubles = true};
  setting.rows = plan.rows;
  setting.sectors = plan.sectors;
  const auto worker = worker_of(script, setting);
  Truth truth;
  const Felt felt = play(script, plan.rate_hz,
                         [&](long, double from, double to) { return worker->tick(from, to); });
  truth.force = felt.windows;
  truth.mean_force = felt.mean();
  for (const WallSide side : {WallSide::outside, WallSide::inside}) {
    if (!script.works(side)) continue;
    FaceGrid& face = truth.face[side == WallSide::outside ? 0 : 1];
    face = worker->face(side);
    truth.displaced += displaced(face, fresh_radius(script, side));
  }
  return truth;
}

bool can_work(const AccuracyScript& script, const AccuracySetting& setting) {
  return setting.model != Model::printed ||
         !(script.works(WallSide::outside) && script.works(WallSide::inside));
}

AccuracyRow measure_accuracy(const AccuracyScript& script, const Truth& truth,
                             const AccuracySetting& setting, WorkClock clock, int passes) {
  AccuracyRow row;
  row.script = script.name;
  row.setting = setting;
  std::vector<double> least;
  std::vector<bool> pressed;
  for (int pass = 0; pass < passes; ++pass) {
    const auto worker = worker_of(script, setting);
    const Felt felt = play(script, setting.rate_hz, [&](long n, double from, double to) {
      const double begin = clock();
      const Forces force = worker->tick(from, to);
      const double took = clock() - begin;
      const auto at = static_cast<std::size_t>(n);
      if (pass == 0) {
        least.push_back(took);
        pressed.push_back(dot(force[0], force[0]) + dot(force[1], force[1]) > 0.0);
      }
      least[at] = std::min(least[at], took);
      return force;
    });
    if (pass > 0) continue;
    row.errors = errors_of(script, *worker, felt, truth, row.displaced);
    row.mean_force = felt.mean();
    for (const auto& window : felt.windows) row.impulse += kForceWindow * length(window[0]);
    row.true_force = truth.mean_force;
  }
  std::vector<double> times;
  for (std::size_t n = 0; n < least.size(); ++n)
    if (pressed[n]) times.push_back(least[n]);
  row.p50 = percentile(times, 0.5);
  row.p999 = percentile(times, 0.999);
  row.worst = percentile(times, 1.0);
  return row;
}

FaceGrid face_left(const AccuracyScript& script, const AccuracySetting& setting, WallSide side) {
  const auto worker = worker_of(script, setting);
  play(script, setting.rate_hz,
       [&](long, double from, double to) { return worker->tick(from, to); });
  return worker->face(side);
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::ptrdiff_t>(
      std::ceil(share * static_cast<double>(values.size()) - 1e-9) - 1.0);
  const auto found = values.begin() + std::max<std::ptrdiff_t>(at, 0);
  std::nth_element(values.begin(), found, values.end());
  return *found;
}

}  // namespace onggi::lab
