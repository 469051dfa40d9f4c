#include "kiosk/lab/measure/witness_report.h"

#include <algorithm>
#include <cmath>

#include "engine/base/nearest_name.h"
#include "kiosk/ground/files/monotonic.h"

namespace onggi::measure {

namespace {

std::vector<WitnessRow> rows_of(const std::string& only) {
  std::vector<WitnessRow> rows;
  for (const lab::WitnessFamily& family : lab::witness_families())
    for (const lab::Witness& witness : family.witnesses)
      if (family.name == only || witness.law.find(only) != std::string_view::npos)
        rows.push_back({std::string(family.name), witness});
  return rows;
}

std::string nearest_law(const std::string& only) {
  std::vector<std::string> names;
  for (const lab::WitnessFamily& family : lab::witness_families()) {
    names.emplace_back(family.name);
    for (const lab::Witness& witness : family.witnesses) names.emplace_back(witness.law);
  }
  return nearest_name(only, names);
}

std::string figure(double value, std::string_view unit) {
  char text[48];
  std::snprintf(text, sizeof text, "%.2g%s", value, unit.empty() ? "" : " ");
  return text + std::string(unit);
}

}  // namespace

std::size_t WitnessReport::failed() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(rows, [](const WitnessRow& row) { return !row.holds(); }));
}

Result<WitnessReport> measure_witnesses(const WitnessPlan& plan, std::FILE* told) {
  WitnessReport report{plan, rows_of(plan.only)};
  if (report.rows.empty()) {
    const std::string near = nearest_law(plan.only);
    return problem("--only " + plan.only, "No law has this in its name.",
                   near.empty() ? "Run it without --only to see all names."
                                : "Did you mean \"" + near + "\"?");
  }
  double next = files::monotonic_seconds() + 1.0;
  for (std::size_t n = 0; n < report.rows.size(); ++n) {
    WitnessRow& row = report.rows[n];
    const double begun = files::monotonic_seconds();
    if (begun > next) {
      std::fprintf(told, "%zu of %zu: %.*s\n", n + 1, report.rows.size(),
                   static_cast<int>(row.witness.law.size()), row.witness.law.data());
      std::fflush(told);
      next = begun + 1.0;
    }
    row.apart = row.witness.measure(plan.altered);
    row.seconds = files::monotonic_seconds() - begun;
  }
  return report;
}

files::Json json_of(const WitnessReport& report) {
  using files::Json;
  Json rows = Json::list();
  for (const WitnessRow& row : report.rows)
    rows.push_back(Json::object({{"family", row.family},
                                 {"law", std::string(row.witness.law)},
                                 {"against", std::string(row.witness.against)},
                                 {"altered", std::string(row.witness.altered)},
                                 {"apart", std::isfinite(row.apart) ? Json(row.apart) : Json()},
                                 {"bound", row.witness.bound},
                                 {"unit", std::string(row.witness.unit)},
                                 {"holds", row.holds()},
                                 {"seconds", row.seconds}}));
  return Json::object(
      {{"altered", report.plan.altered}, {"rows", rows}, {"failed", report.failed()}});
}

std::string text_of(const WitnessReport& report) {
  std::string text = "| law | against | apart | bound | |\n|---|---|---|---|---|\n";
  double seconds = 0.0;
  for (const WitnessRow& row : report.rows) {
    const lab::Witness& of = row.witness;
    text.append("| ").append(of.law).append(" | ").append(of.against);
    text += " | " + figure(row.apart, of.unit) + " | " + figure(of.bound, of.unit) + " | ";
    text += row.holds() ? "holds |\n" : "**does not hold** |\n";
    seconds += row.seconds;
  }
  char last[80];
  std::snprintf(last, sizeof last, "\n%zu of %zu laws hold. %.1f s.\n",
                report.rows.size() - report.failed(), report.rows.size(), seconds);
  return text + last;
}

}  // namespace onggi::measure
