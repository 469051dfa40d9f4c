#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/lab/witness.h"
#include "kiosk/ground/files/json.h"

namespace onggi::measure {

/// Which witnesses are asked, and how.
struct WitnessPlan {
  std::string only;      ///< A part of a law's name, or a family's name; empty: all.
  double altered = 0.0;  ///< Share by which the engine's side of each law is off: see lab::Witness.
};

/// The answer of one.
struct WitnessRow {
  std::string family;
  lab::Witness witness;
  double apart = 0.0;
  double seconds = 0.0;  ///< That it took.
  bool holds() const { return witness.holds(apart); }
};

struct WitnessReport {
  WitnessPlan plan;
  std::vector<WitnessRow> rows;
  std::size_t failed() const;  ///< Rows that do not hold.
};

/// Asks the witnesses of `plan`, one after the other on this thread: some seconds in all. Tells
/// `told` once a second how far it is. Problem if no law has such a name.
Result<WitnessReport> measure_witnesses(const WitnessPlan& plan, std::FILE* told);

/// {altered, rows: [{family, law, against, altered, apart, bound, unit, holds, seconds}], failed}.
/// `apart` is null where it is no number.
files::Json json_of(const WitnessReport& report);
/// A table in Markdown, a row a law, and a sentence below it.
std::string text_of(const WitnessReport& report);

}  // namespace onggi::measure
