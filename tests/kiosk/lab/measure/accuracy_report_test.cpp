#include "kiosk/lab/measure/accuracy_report.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "kiosk/lab/measure/accuracy_picture.h"

namespace onggi::measure::accuracy_report_test {
namespace {

using lab::AccuracySetting;

lab::AccuracyRow row(AccuracySetting::Model model, int rows, double us, double mm) {
  lab::AccuracyRow out;
  out.script = "press";
  out.setting.model = model;
  out.setting.rows = rows;
  out.setting.sectors = rows * 9 / 10;
  out.p50 = 0.5 * us;
  out.p999 = us;
  out.worst = 2.0 * us;
  out.errors = {1e-3 * mm, 4e-3 * mm, 0.01, 0.002};
  out.mean_force = 0.9;
  out.true_force = 1.0;
  return out;
}

// As a run might have come to: our grids converge, the printed force does not.
AccuracyReport some_report() {
  AccuracyReport report;
  report.machine = "A processor, 2 cores";
  report.command = "onggi lab accuracy --quick";
  report.made = "2026-11-23, commit bc6a5ac";
  report.plan.seed = 9;
  for (const auto& [rows, us, mm] :
       {std::tuple{100, 3.0, 0.2}, std::tuple{200, 6.0, 0.04}, std::tuple{400, 20.0, 0.01}}) {
    report.rows.push_back(row(AccuracySetting::Model::shipped, rows, us, mm));
    report.rows.push_back(row(AccuracySetting::Model::printed, rows, 3.0 * us, 0.5));
    report.rows.back().mean_force = 1e-5 * rows * rows;
  }
  report.settings = report.scenes = lab::summaries(report.rows);
  report.edge = lab::pareto_edge(report.settings);
  report.recommended = lab::recommend(report.scenes, 1000.0);
  report.orders = orders_of(report.rows);
  report.unstable = {{AccuracySetting::Model::printed, 100, 90, "finite: no number"}};
  return report;
}

TEST(AccuracyReport, JsonHasEveryRowWithTheThreeErrorsAndTheRecommendation) {
  const auto json = nlohmann::json::parse(json_of(some_report()).text());
  EXPECT_EQ(json["machine"], "A processor, 2 cores");
  EXPECT_EQ(json["seed"], 9);
  ASSERT_EQ(json["rows"].size(), 6u);
  for (const char* key : {"script", "model", "rule", "quadrature", "precision", "rows", "sectors",
                          "rate_hz", "substeps", "tick_us_p50", "tick_us_p999", "tick_us_worst",
                          "shape_mm_rms", "shape_mm_max", "force_n_rms", "volume_pct"})
    EXPECT_TRUE(json["rows"][0].contains(key)) << key;
  EXPECT_NEAR(json["rows"][0]["shape_mm_rms"].get<double>(), 0.2, 1e-12);
  EXPECT_NEAR(json["rows"][0]["volume_pct"].get<double>(), 0.2, 1e-12);
  EXPECT_EQ(json["pareto"].size(), 3u);
  EXPECT_EQ(json["recommended"]["rows"], 200);
  EXPECT_EQ(json["recommended"]["finer"]["rows"], 400);
  EXPECT_FALSE(json["orders"].empty());
}

TEST(AccuracyReport, AnOrderThatIsNoneIsNullAndOtherwiseSaysWhetherItIsTheTheorys) {
  AccuracyReport report = some_report();
  for (AccuracyOrder& order : report.orders)
    order.order.p = std::numeric_limits<double>::quiet_NaN();
  const auto json = nlohmann::json::parse(json_of(report).text());
  EXPECT_TRUE(json["orders"][0]["order"].is_null());
  EXPECT_TRUE(json["orders"][0]["asymptotic"].is_boolean());
}

TEST(AccuracyReport, ACuratorReadsWhatToTakeWhatItCostsAndWhatFinerWouldCost) {
  const std::string words = words_of(*some_report().recommended);
  EXPECT_NE(words.find("200 rows x 180 sectors"), std::string::npos) << words;
  EXPECT_NE(words.find("0.040 mm off"), std::string::npos) << words;
  EXPECT_NE(words.find("0.6 %"), std::string::npos) << words;
  EXPECT_NE(words.find("Twice as fine would be 0.010 mm off and use 2.0 %"), std::string::npos)
      << words;
}

TEST(AccuracyReport, OnAMachineTooSlowItSaysSoAndPromisesNothing) {
  AccuracyReport report = some_report();
  for (lab::SettingSummary& one : report.scenes) one.p999 *= 1e3;
  const std::string words = words_of(*lab::recommend(report.scenes, 1000.0));
  EXPECT_NE(words.find("too slow"), std::string::npos) << words;
  EXPECT_EQ(words.find("Nobody can tell"), std::string::npos) << words;
}

TEST(AccuracyReport, TheCsvSaysMachineCommandSeedAndCommitAndHasALineARow) {
  const std::string csv = csv_of(some_report());
  EXPECT_TRUE(
      csv.starts_with("# A processor, 2 cores\n# onggi lab accuracy --quick, seed 9\n"
                      "# 2026-11-23, commit bc6a5ac\n"));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 4 + 6);
}

TEST(AccuracyReport, ACsvReadBackIsTheSameCsvWithTheSameRecommendation) {
  AccuracyReport report = some_report();
  report.rows[0].setting.model = AccuracySetting::Model::plain;
  report.rows[0].setting.doubles = true;
  report.rows[0].setting.rule = lab::TimeRule::exact;
  report.rows[0].setting.quadrature = lab::Quadrature::area;
  const std::string csv = csv_of(report);
  const auto back = report_of_csv(csv, "accuracy.csv");
  ASSERT_TRUE(back) << to_text(back.error());
  EXPECT_EQ(csv_of(*back), csv);
  EXPECT_TRUE(back->plan.quick);
  EXPECT_EQ(back->plan.seed, 9u);
  for (std::size_t n = 0; n < report.rows.size(); ++n)
    EXPECT_TRUE(back->rows[n].setting == report.rows[n].setting) << n;
}

TEST(AccuracyReport, ADamagedCsvIsToldByItsLine) {
  const std::string csv = csv_of(some_report());
  const auto where = [](const std::string& text) {
    const auto read = report_of_csv(text, "accuracy.csv");
    return read ? std::string("it was read") : read.error().where;
  };
  EXPECT_EQ(where(csv), "it was read");
  EXPECT_EQ(where(csv.substr(2)), "accuracy.csv, line 1");
  EXPECT_EQ(where(csv.substr(0, csv.size() - 30)), "accuracy.csv, line 10");
  std::string other = csv;
  other.replace(other.find("shipped"), 7, "clipped");
  EXPECT_EQ(where(other), "accuracy.csv, line 5");
  EXPECT_EQ(where(""), "accuracy.csv");
}

// A row of coils as a run gives it.
lab::AccuracyRow coil_row(int rows, double mm) {
  lab::AccuracyRow out = row(AccuracySetting::Model::shipped, rows, 50.0, mm);
  out.script = "coil";
  out.errors.force_rms = out.mean_force = out.true_force = out.impulse =
      std::numeric_limits<double>::quiet_NaN();
  out.displaced = 1e-6 * (1.0 + mm);
  return out;
}

TEST(AccuracyReport, AForceThatWasNotComparedIsNullInJsonAndComesBackFromTheCsv) {
  AccuracyReport report = some_report();
  report.rows.push_back(coil_row(400, 0.02));
  const auto json = nlohmann::json::parse(json_of(report).text());
  EXPECT_TRUE(json["rows"].back()["force_n_rms"].is_null());
  EXPECT_TRUE(json["rows"].back()["true_force_n_mean"].is_null());
  EXPECT_TRUE(json["rows"].back()["shape_mm_rms"].is_number());
  const auto back = report_of_csv(csv_of(report), "accuracy.csv");
  ASSERT_TRUE(back) << to_text(back.error());
  EXPECT_EQ(csv_of(*back), csv_of(report));
}

TEST(AccuracyReport, CoilsHaveOrdersOfShapeAndVolumeButNoneOfForce) {
  AccuracyReport report = some_report();
  for (const auto& [rows, mm] : {std::pair{100, 0.12}, std::pair{200, 0.04}, std::pair{400, 0.014}})
    report.rows.push_back(coil_row(rows, mm));
  report.orders = orders_of(report.rows);
  for (const AccuracyOrder& order : report.orders)
    EXPECT_FALSE(order.script == "coil" && order.quantity == "force");
  const std::string text = text_of(report);
  EXPECT_NE(text.find("\ncoil       ours      grid"), std::string::npos) << text;
  EXPECT_NE(text.find("A ring of coil as it is laid"), std::string::npos) << text;
}

TEST(AccuracyReport, ThePictureHasALineOfCoilsOnlyWhereTheyWereMeasured) {
  AccuracyReport report = some_report();
  const std::size_t without = chart_of(report).lines.size();
  for (const int rows : {200, 400}) report.rows.push_back(coil_row(rows, 0.02));
  const plots::AccuracyChart chart = chart_of(report);
  ASSERT_EQ(chart.lines.size(), without + 1);
  EXPECT_EQ(chart.lines.back().name, "a ring of coil");
  ASSERT_EQ(chart.lines.back().marks.size(), 2u);
  EXPECT_NEAR(chart.lines.back().marks[0].mm, 0.02, 1e-12);
  EXPECT_EQ(chart.lines.back().marks[0].us, 50.0);
  report.rows.back().errors.shape_rms = 3.9e-7;  // nearer than a tenth of what is sure
  report.truth_mm = 0.004;
  EXPECT_EQ(chart_of(report).lines.back().marks.size(), 1u);
}

TEST(AccuracyReport, APersonReadsThatThePrintedForceGrowsWithTheGrid) {
  const std::string text = text_of(some_report());
  EXPECT_NE(text.find("does not converge"), std::string::npos);
  EXPECT_NE(text.find("not asymptotic"), std::string::npos);
  EXPECT_NE(text.find("400 x 360   printed    1.6000"), std::string::npos) << text;
  EXPECT_NE(text.find("Random hands broke it: printed, 100 x 90"), std::string::npos);
}

TEST(AccuracyReport, ThePictureHasThePrintedSettingsHollowAndThoseThatBrokeRinged) {
  const plots::AccuracyChart chart = chart_of(some_report());
  int hollow = 0, ringed = 0;
  for (const auto& line : chart.lines)
    for (const auto& mark : line.marks) {
      hollow += line.hollow;
      ringed += mark.broke;
    }
  EXPECT_EQ(hollow, 3);
  EXPECT_EQ(ringed, 1);
  ASSERT_TRUE(chart.chosen);
  EXPECT_NEAR(chart.chosen->mm, 0.04, 1e-12);
  EXPECT_EQ(chart.edge.size(), 3u);
  for (const char* word : {"seed 9", "A processor, 2 cores", "2026-11-23, commit bc6a5ac"})
    EXPECT_NE(chart.says.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace onggi::measure::accuracy_report_test
