#include "kiosk/lab/measure/accuracy_report.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "kiosk/lab/measure/accuracy_built.h"

namespace onggi::measure {
namespace {

using files::Json;
using Setting = lab::AccuracySetting;
using Model = Setting::Model;

[[gnu::format(printf, 1, 2)]] std::string line(const char* format, ...) {
  char text[400];
  va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  return text;
}

const char* precision_of(const Setting& setting) {
  return setting.model == Model::printed || setting.doubles ? "double" : "float";
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json setting_json(const Setting& s) {
  return Json::object({{"model", lab::name_of(s.model)},
                       {"rule", lab::name_of(s.rule)},
                       {"quadrature", lab::name_of(s.quadrature)},
                       {"precision", precision_of(s)},
                       {"rows", s.rows},
                       {"sectors", s.sectors},
                       {"rate_hz", s.rate_hz},
                       {"substeps", s.substeps}});
}

template <class Result>
void put_figures(Json& json, const Result& of) {
  json["tick_us_p50"] = of.p50;
  json["tick_us_p999"] = of.p999;
  json["tick_us_worst"] = of.worst;
  json["shape_mm_rms"] = 1e3 * of.errors.shape_rms;
  json["shape_mm_max"] = 1e3 * of.errors.shape_max;
  json["force_n_rms"] = of.errors.force_rms;
  json["volume_pct"] = 1e2 * of.errors.volume;
}

Json summary_json(const lab::SettingSummary& one) {
  Json json = setting_json(one.setting);
  put_figures(json, one);
  json["force_pct"] = 1e2 * one.force_share;
  json["tick_share_pct"] = 1e2 * one.share();
  json["scripts"] = one.scripts;
  return json;
}

std::string order_words(const AccuracyOrder* one) {
  if (one == nullptr) return "    -";
  if (converged(*one)) return line("   within %.0e", one->last_step);
  const std::string p = std::isfinite(one->order.p) ? line("%5.1f", one->order.p) : "    -";
  return p + (one->order.asymptotic ? line("  +-%-12.1e", one->order.uncertainty)
                                    : std::string("  not asymptotic"));
}

void tell_grids(const AccuracyReport& report, std::string& text) {
  text += "\nThe engine at 1 kHz, the worst of all scripts and presets that a grid worked:\n";
  text += line("%-13s %9s %9s %8s %11s %11s %10s %8s\n", "rows x sect.", "p50 us", "p99.9 us",
               "of tick", "shape mm", "worst mm", "force N", "volume");
  for (const lab::SettingSummary& one : report.scenes)
    if (one.setting.model == Model::shipped && one.setting.rate_hz == 1000.0 &&
        one.setting.substeps == 1)
      text += line("%5d x %-5d %9.1f %9.1f %6.1f %% %11.4f %11.3f %10.5f %6.2f %%\n",
                   one.setting.rows, one.setting.sectors, one.p50, one.p999, 1e2 * one.share(),
                   1e3 * one.errors.shape_rms, 1e3 * one.errors.shape_max, one.errors.force_rms,
                   1e2 * one.errors.volume);
}

void tell_printed_force(const AccuracyReport& report, std::string& text) {
  text += "\nThe printed force does not converge: it grows with the grid. Mean in press, N:\n";
  double truth = 0.0;
  for (const lab::AccuracyRow& row : report.rows) {
    if (row.script != "press" || row.setting.rate_hz != 1000.0 || row.setting.substeps != 1)
      continue;
    truth = row.true_force;
    if (row.setting.model != Model::printed) continue;
    double ours = 0.0;
    for (const lab::AccuracyRow& other : report.rows)
      if (other.script == row.script && other.setting.model == Model::shipped &&
          other.setting.rows == row.setting.rows && other.setting.rate_hz == 1000.0 &&
          other.setting.substeps == 1)
        ours = other.mean_force;
    text += line("  %5d x %-5d printed %9.4f   ours %7.4f\n", row.setting.rows, row.setting.sectors,
                 row.mean_force, ours);
  }
  text += line("  true %.4f\n", truth);
}

void tell_orders(const AccuracyReport& report, std::string& text) {
  text += "\nObserved orders on the finest steps, and what these may be off (mm, N s, mm^3):\n";
  text += line("%-10s %-9s %-9s %-23s %-23s %-23s\n", "", "", "", "shape", "force", "volume");
  struct Line {
    const char *name, *knob;
    Model model;
    lab::TimeRule rule;
  };
  using lab::TimeRule;
  for (const Line& of : {Line{"ours", "grid", Model::shipped, TimeRule::shipped},
                         Line{"printed", "grid", Model::printed, TimeRule::printed},
                         Line{"middle", "tick", Model::plain, TimeRule::shipped},
                         Line{"exact", "tick", Model::plain, TimeRule::exact},
                         Line{"euler", "tick", Model::plain, TimeRule::printed}})
    for (const char* script :
         {"press", "pull", "groove", "collar", "centre", "near_axis", "throw", "coil", "blows"}) {
      const auto order = [&](const char* quantity) {
        return finest_order(report.orders, of.model, of.rule, script, of.knob, quantity);
      };
      if (order("force") == nullptr && order("volume") == nullptr) continue;
      text += line("%-10s %-9s %-9s %-23s %-23s %-23s\n", script, of.name, of.knob,
                   order_words(order("shape")).c_str(), order_words(order("force")).c_str(),
                   order_words(order("volume")).c_str());
    }
  text +=
      "Theory: 1.5 for the shape and 2 for sums in the grid; 2 in the tick by middle, what ships; "
      "1\n"
      "for the force by exact, 1 by euler, whose clay is another at every tick.\n"
      "\"within\": the finest two differ by no more, and their order means nothing.\n";
}

}  // namespace

Json json_of(const AccuracyReport& report) {
  Json rows = Json::list();
  for (const lab::AccuracyRow& row : report.rows) {
    Json one = Json::object({{"script", row.script}});
    const Setting& s = row.setting;
    one["model"] = lab::name_of(s.model);
    one["rule"] = lab::name_of(s.rule);
    one["quadrature"] = lab::name_of(s.quadrature);
    one["precision"] = precision_of(s);
    one["rows"] = s.rows;
    one["sectors"] = s.sectors;
    one["rate_hz"] = s.rate_hz;
    one["substeps"] = s.substeps;
    put_figures(one, row);
    one["force_n_mean"] = row.mean_force;
    one["true_force_n_mean"] = row.true_force;
    rows.push_back(std::move(one));
  }
  Json orders = Json::list();
  for (const AccuracyOrder& o : report.orders) {
    Json one = setting_json(o.finest);
    one["script"] = o.script;
    one["knob"] = o.knob;
    one["quantity"] = o.quantity;
    one["theory"] = o.theory;
    one["order"] = finite(o.order.p);
    one["uncertainty"] = finite(o.order.uncertainty);
    one["gci_pct"] = o.quantity == "shape" ? Json() : finite(1e2 * o.order.gci);
    one["asymptotic"] = o.order.asymptotic;
    orders.push_back(std::move(one));
  }
  Json pareto = Json::list();
  for (const std::size_t n : report.edge) pareto.push_back(summary_json(report.settings[n]));
  Json unstable = Json::list();
  for (const UnstableSetting& one : report.unstable)
    unstable.push_back(Json::object({{"model", lab::name_of(one.model)},
                                     {"rows", one.rows},
                                     {"sectors", one.sectors},
                                     {"what", one.what}}));
  Json recommended;
  if (report.recommended) {
    recommended = summary_json(report.recommended->chosen);
    recommended["fine_enough"] = report.recommended->fine_enough;
    recommended["in_time"] = report.recommended->in_time;
    recommended["finer"] =
        report.recommended->finer ? summary_json(*report.recommended->finer) : Json();
    recommended["words"] = words_of(*report.recommended);
  }
  return Json::object({{"machine", report.machine},
                       {"command", report.command},
                       {"made", report.made},
                       {"seed", report.plan.seed},
                       {"seconds", report.seconds},
                       {"reference_mm", report.truth_mm},
                       {"rows", rows},
                       {"orders", orders},
                       {"pareto", pareto},
                       {"unstable", unstable},
                       {"recommended", recommended}});
}

constexpr const char* kCsvHead =
    "script,model,rule,quadrature,precision,rows,sectors,rate_hz,substeps,"
    "tick_us_p50,tick_us_p999,tick_us_worst,shape_mm_rms,shape_mm_max,force_n_rms,"
    "volume_pct,force_n_mean,true_force_n_mean\n";

std::string csv_of(const AccuracyReport& report) {
  std::string text = "# " + report.machine + "\n# " + report.command +
                     line(", seed %llu\n", static_cast<unsigned long long>(report.plan.seed)) +
                     "# " + report.made + "\n" + kCsvHead;
  for (const lab::AccuracyRow& r : report.rows) {
    const Setting& s = r.setting;
    text += "\"" + r.script + "\"" +
            line(",%s,%s,%s,%s,%d,%d,%g,%d,%.2f,%.2f,%.2f,%.6f,%.5f,%.6f,%.5f,%.5f,%.5f\n",
                 lab::name_of(s.model), lab::name_of(s.rule), lab::name_of(s.quadrature),
                 precision_of(s), s.rows, s.sectors, s.rate_hz, s.substeps, r.p50, r.p999, r.worst,
                 1e3 * r.errors.shape_rms, 1e3 * r.errors.shape_max, r.errors.force_rms,
                 1e2 * r.errors.volume, r.mean_force, r.true_force);
  }
  return text;
}

namespace {

/// The one of `all` with this name.
template <class Choice, std::size_t count>
bool by_name(const std::string& name, const Choice (&all)[count], Choice& found) {
  for (const Choice one : all)
    if (name == lab::name_of(one)) return found = one, true;
  return false;
}

bool row_of_csv(const std::string& text, lab::AccuracyRow& row) {
  char script[64], model[16], rule[16], sum[16], precision[16];
  Setting& s = row.setting;
  lab::AccuracyErrors& off = row.errors;
  int end = 0;
  const int read =
      std::sscanf(text.c_str(),
                  "\"%63[^\"]\",%15[^,],%15[^,],%15[^,],%15[^,],%d,%d,%lf,%d,%lf,%lf,%lf,%lf,%lf,%"
                  "lf,%lf,%lf,%lf%n",
                  script, model, rule, sum, precision, &s.rows, &s.sectors, &s.rate_hz, &s.substeps,
                  &row.p50, &row.p999, &row.worst, &off.shape_rms, &off.shape_max, &off.force_rms,
                  &off.volume, &row.mean_force, &row.true_force, &end);
  if (read != 18 || static_cast<std::size_t>(end) != text.size()) return false;
  constexpr Model kModels[] = {Model::printed, Model::plain, Model::shipped};
  constexpr lab::TimeRule kRules[] = {lab::TimeRule::printed, lab::TimeRule::exact,
                                      lab::TimeRule::shipped};
  constexpr lab::Quadrature kSums[] = {lab::Quadrature::none, lab::Quadrature::area,
                                       lab::Quadrature::edges};
  if (!by_name(model, kModels, s.model) || !by_name(rule, kRules, s.rule) ||
      !by_name(sum, kSums, s.quadrature))
    return false;
  row.script = script;
  s.doubles = s.model == Model::plain && std::string(precision) == "double";
  off.shape_rms *= 1e-3;
  off.shape_max *= 1e-3;
  off.volume *= 1e-2;
  return precision == std::string(precision_of(s));
}

}  // namespace

Result<AccuracyReport> report_of_csv(const std::string& csv, const std::string& name) {
  AccuracyReport report;
  std::istringstream lines(csv);
  std::string text;
  int at = 0;
  for (; std::getline(lines, text); ++at) {
    bool good = true;
    if (at < 3) {
      good = text.starts_with("# ");
      (at == 0   ? report.machine
       : at == 1 ? report.command
                 : report.made) = text.substr(good ? 2 : 0);
    } else if (at == 3) {
      good = text + '\n' == kCsvHead;
    } else {
      good = row_of_csv(text, report.rows.emplace_back());
    }
    if (!good)
      return problem(name + ", line " + std::to_string(at + 1),
                     "This is no line of the table that onggi lab accuracy --csv writes.",
                     "Name a table that it wrote, whole.");
  }
  const std::size_t seed = report.command.rfind(", seed ");
  if (seed == std::string::npos || report.rows.empty())
    return problem(name, "The table has no seed or no rows.",
                   "Name a table that onggi lab accuracy --csv wrote, whole.");
  report.plan.seed = std::strtoull(report.command.c_str() + seed + 7, nullptr, 10);
  report.command.resize(seed);
  report.plan.quick = report.command.ends_with("--quick");
  return report;
}

std::string words_of(const Setting& s) {
  std::string text = s.model == Model::shipped ? "ours"
                     : s.model == Model::printed
                         ? "as printed"
                         : std::string("plain code, ") + lab::name_of(s.rule) + ", " +
                               lab::name_of(s.quadrature) + ", " + precision_of(s);
  text += line(", %d x %d", s.rows, s.sectors);
  if (s.rate_hz != 1000.0) text += line(", %g kHz", 1e-3 * s.rate_hz);
  if (s.substeps > 1) text += line(", %d steps a tick", s.substeps);
  return text;
}

std::string words_of(const lab::Recommendation& r) {
  const lab::SettingSummary& is = r.chosen;
  std::string text = line(
      "At 1 kHz take %d rows x %d sectors. The clay is %.3f mm off in the mean and %.2f mm at the "
      "worst place, its force %.1f %% off, and 999 of 1000 ticks use at most %.1f %% of the time "
      "they have.",
      is.setting.rows, is.setting.sectors, 1e3 * is.errors.shape_rms, 1e3 * is.errors.shape_max,
      1e2 * is.force_share, 1e2 * is.share());
  if (r.finer && r.finer->errors.shape_rms > 0.9 * is.errors.shape_rms)
    text += line(" Twice as fine would come no nearer in the same tick, and use %.1f %%.",
                 1e2 * r.finer->share());
  else if (r.finer)
    text += line(" Twice as fine would be %.3f mm off and use %.1f %%.",
                 1e3 * r.finer->errors.shape_rms, 1e2 * r.finer->share());
  if (!r.in_time)
    text += line(" No grid keeps within %.0f %% of the tick here: this machine is too slow.",
                 1e2 * lab::kTickBudget);
  else if (!r.fine_enough)
    text += " A finer one would feel or look better, but it is too slow here.";
  else
    text += " Nobody can tell it from a finer one by a device, by two fingers or by its force.";
  return text;
}

std::string text_of(const AccuracyReport& report) {
  std::string text =
      line("What accuracy costs in time. %s. %zu measurements in %.0f s, seed %llu.\n",
           report.machine.c_str(), report.rows.size(), report.seconds,
           static_cast<unsigned long long>(report.plan.seed));
  text += line("The reference is within %.4f mm of one half as fine.\n", report.truth_mm);
  tell_grids(report, text);
  text += words_of_built(report.rows);
  tell_printed_force(report, text);
  tell_orders(report, text);
  text += "\nThe edge: what nothing else beats in time and shape at once.\n";
  for (const std::size_t n : report.edge) {
    const lab::SettingSummary& one = report.settings[n];
    text += line("  %9.1f us %9.4f mm  %s\n", one.p999, 1e3 * one.errors.shape_rms,
                 words_of(one.setting).c_str());
  }
  for (const UnstableSetting& one : report.unstable)
    text += line("Random hands broke it: %s, %d x %d: %s\n", lab::name_of(one.model), one.rows,
                 one.sectors, one.what.c_str());
  if (report.recommended) text += "\n" + words_of(*report.recommended) + "\n";
  return text;
}

}  // namespace onggi::measure
