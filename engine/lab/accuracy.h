#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/lab/accuracy_script.h"
#include "engine/lab/face_grid.h"

namespace onggi::lab {

/// Who works a script, and how.
struct AccuracySetting {
  enum class Model : std::uint8_t {
    printed,  ///< Lee, Han & Choi 2008 (PaperModel), double, unfiltered, without its friction.
    plain,    ///< PlainWall: one thing at a time of the printed law.
    shipped,  ///< The engine: a whole tick of Scene::step.
  };
  Model model = Model::shipped;
  TimeRule rule = TimeRule::shipped;
  Quadrature quadrature = Quadrature::edges;
  bool doubles = false;  ///< Arithmetic and storage of `plain`; the others' are their own.
  int rows = 400, sectors = 360;
  double rate_hz = 1000.0;
  int substeps = 1;  ///< Equal parts of a tick; the engine may part each again (steps_for).
  friend bool operator==(const AccuracySetting&, const AccuracySetting&) = default;
};
const char* name_of(AccuracySetting::Model model);
const char* name_of(TimeRule rule);
const char* name_of(Quadrature quadrature);

/// What a script truly leaves and feels: PlainWall in doubles, on a fine grid and in short steps.
struct Truth {
  std::array<FaceGrid, 2> face;            ///< Outside and inside; without rows where not worked.
  std::vector<std::array<Vec3, 2>> force;  ///< Means of each kForceWindow, by ball, N.
  double displaced = 0.0;                  ///< m^3
  double mean_force = 0.0;                 ///< Of the first ball's windows with any, N.
};
/// How fine a truth is.
struct TruthPlan {
  int rows = 1900, sectors = 1500;
  double rate_hz = 8000.0;
};
/// Seconds of work. Allocates.
Truth truth_of(const AccuracyScript& script, const TruthPlan& plan = {});

/// Three errors that are never mixed.
struct AccuracyErrors {
  double shape_rms = 0.0, shape_max = 0.0;  ///< Of the worked faces as they are drawn, m.
  double force_rms = 0.0;  ///< Over the windows in which either is pressed, all balls, N.
  double volume = 0.0;     ///< Of what was displaced, a share of the true.
};

/// What a setting came to in a script.
struct AccuracyRow {
  std::string script;
  AccuracySetting setting;
  double p50 = 0.0, p999 = 0.0, worst = 0.0;  ///< Ticks in which clay is pressed, us.
  AccuracyErrors errors;
  double mean_force = 0.0;  ///< As Truth's, N.
  double true_force = 0.0;  ///< Truth's, N.
  double impulse = 0.0;     ///< Sum of the first ball's force over time, N s.
  double displaced = 0.0;   ///< m^3
};

/// Microseconds that the calling thread has worked; whoever measures brings it.
using WorkClock = double (*)();

/// Works `script` by `setting`, `passes` times (at least once): of each tick the least of its times
/// counts, so that what the machine did besides is not in it. The printed model has one face: a
/// script that works two is not for it (can_work). Allocates; not for the 1 kHz thread.
AccuracyRow measure_accuracy(const AccuracyScript& script, const Truth& truth,
                             const AccuracySetting& setting, WorkClock clock, int passes = 1);
/// The outer or inner face that it leaves, for a picture. Allocates.
FaceGrid face_left(const AccuracyScript& script, const AccuracySetting& setting, WallSide side);
bool can_work(const AccuracyScript& script, const AccuracySetting& setting);

/// The share `share` (0..1) of `values` is not above what it gives; 0 of none.
double percentile(std::vector<double> values, double share);

}  // namespace onggi::lab
