#pragma once

#include <optional>
#include <vector>

#include "engine/lab/accuracy.h"

namespace onggi::lab {

/// A setting's worst results over all its scripts.
struct SettingSummary {
  AccuracySetting setting;
  double p50 = 0.0, p999 = 0.0, worst = 0.0;  ///< us, the largest of each.
  AccuracyErrors errors;                      ///< The largest of each.
  double force_share = 0.0;  ///< Largest force error, as a share of the true mean force.
  int scripts = 0;           ///< Number of scripts.
  /// Share of a tick's time that the 99.9th percentile takes.
  double share() const { return 1e-6 * p999 * setting.rate_hz; }
};

/// One summary a setting, in order of first appearance. `true_force` of a row: N.
std::vector<SettingSummary> summaries(const std::vector<AccuracyRow>& rows);

/// Indices of the settings that no other beats in both time (p99.9 of a tick) and shape (root mean
/// square), quickest first: the Pareto front.
std::vector<std::size_t> pareto_edge(const std::vector<SettingSummary>& all);

/// What a person, or a device, can tell apart (engine/docs/accuracy.md has the sources).
struct HumanThresholds {
  double device = 5.5e-5;  ///< What a PHANToM Omni resolves, m.
  double wall = 4e-4;      ///< Difference of two walls that finger and thumb can tell (Ho 1996), m.
  double pixel = 2.7e-4;   ///< Of the exhibit's screen, m of clay.
  double force = 0.07;     ///< Share by which forces are told apart (Pang, Tan & Durlach 1991).
};
/// Share of a tick that clay may take. The rest is for drawing, the system and the unforeseen.
inline constexpr double kTickBudget = 0.25;

/// The setting for a machine, and its margin.
struct Recommendation {
  SettingSummary chosen;
  std::optional<SettingSummary> finer;  ///< The next finer grid, if one was measured.
  bool fine_enough = false;  ///< Shape within `device` in the mean and `wall` at the worst place,
                             ///< force within `force`.
  bool in_time = false;      ///< Its 99.9th percentile is within kTickBudget.
};
/// Among the shipped model's grids at `rate_hz` in one step that worked the most scripts: the
/// coarsest that is fine enough and in time; else the finest in time; else the quickest. Empty if
/// none was measured.
std::optional<Recommendation> recommend(const std::vector<SettingSummary>& all, double rate_hz,
                                        const HumanThresholds& thresholds = {});

}  // namespace onggi::lab
