#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/lab/accuracy_script.h"
#include "engine/lab/face_grid.h"

namespace onggi::lab {

/// Which model works a script, and how.
struct AccuracySetting {
  enum class Model : std::uint8_t {
    printed,  ///< Lee, Han & Choi 2008 (PaperModel), double, unfiltered, without its friction.
    plain,    ///< PlainWall: one thing at a time of the printed law.
    shipped,  ///< PlainWall: the printed law with one thing changed at a time.
  };
  Model model = Model::shipped;
  TimeRule rule = TimeRule::shipped;
  Quadrature quadrature = Quadrature::edges;
  bool doubles = false;  ///< Arithmetic and storage of `plain`; other models have their own.
  int rows = 400, sectors = 360;
  double rate_hz = 1000.0;
  int substeps = 1;  ///< Equal parts of a tick; the engine may divide each further (steps_for).
  friend bool operator==(const AccuracySetting&, const AccuracySetting&) = default;
};
const char* name_of(AccuracySetting::Model model);
const char* name_of(TimeRule rule);
const char* name_of(Quadrature quadrature);

/// The reference result of a script: PlainWall in doubles, on a fine grid and in short steps.
struct Truth {
  std::array<FaceGrid, 2> face;            ///< Outside and inside; empty if the face is not worked.
  std::vector<std::array<Vec3, 2>> force;  ///< Means of each kForceWindow, by ball, N.
  double displaced = 0.0;                  ///< Displaced volume, m^3.
  double mean_force = 0.0;                 ///< Mean over the first ball's windows with force, N.
};
/// Grid and steps of the reference.
struct TruthPlan {
  int rows = 1900, sectors = 1500;
  double rate_hz = 8000.0;
};
/// Seconds of work. Allocates.
Truth truth_of(const AccuracyScript& script, const TruthPlan& plan = {});

/// Three errors that are never added up.
struct AccuracyErrors {
  double shape_rms = 0.0, shape_max = 0.0;  ///< Of the worked faces as drawn, m.
  double force_rms = 0.0;  ///< Over windows in which either model presses, all balls, N.
  double volume = 0.0;     ///< As a share of the displaced volume.
};

/// The result of a setting in a script.
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

/// Microseconds that the calling thread has worked; the caller brings the clock.
using WorkClock = double (*)();

/// Works `script` by `setting`, `passes` times (at least once). Each tick counts with the least of
/// its times, which leaves other programs out. The printed model has one face, so it cannot work a
/// script of two (can_work). Allocates; not for the 1 kHz thread.
AccuracyRow measure_accuracy(const AccuracyScript& script, const Truth& truth,
                             const AccuracySetting& setting, WorkClock clock, int passes = 1);
/// The outer or inner face that remains, for a picture. Allocates.
FaceGrid face_left(const AccuracyScript& script, const AccuracySetting& setting, WallSide side);
bool can_work(const AccuracyScript& script, const AccuracySetting& setting);

/// The value that a share `share` (0..1) of `values` does not exceed; 0 if empty.
double percentile(std::vector<double> values, double share);

}  // namespace onggi::lab
