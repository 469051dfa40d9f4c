#pragma once

#include <string>

#include "kiosk/ground/files/json.h"
#include "kiosk/lab/measure/accuracy_run.h"

namespace onggi::measure {

/// {machine, command, made, seed, rows: [{script, model, rule, quadrature, precision, rows,
/// sectors, rate_hz, substeps, tick_us_p50, tick_us_p999, tick_us_worst, shape_mm_rms,
/// shape_mm_max, force_n_rms, volume_pct, force_n_mean, true_force_n_mean}], orders: [...], pareto:
/// [...], unstable: [...], recommended: {...}}. An undefined order is null, and so is a force that
/// was not compared.
files::Json json_of(const AccuracyReport& report);
/// Only the rows, after three lines that begin with # and give machine, command, date and commit.
std::string csv_of(const AccuracyReport& report);
/// What csv_of() wrote, read back; the rest of the report is empty. Problem with the line of `name`
/// that is not of such a table.
Result<AccuracyReport> report_of_csv(const std::string& csv, const std::string& name);
/// The report for people: the grids, coils and blows, the growth of the printed force, the orders,
/// the edge, and the recommendation.
std::string text_of(const AccuracyReport& report);

/// The recommendation for curators, two or three sentences.
std::string words_of(const lab::Recommendation& recommended);
/// The setting in a few words: "ours, 400 x 360".
std::string words_of(const lab::AccuracySetting& setting);

}  // namespace onggi::measure
