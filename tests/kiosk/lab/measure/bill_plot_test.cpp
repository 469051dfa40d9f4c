#include "kiosk/lab/measure/bill_plot.h"

#include <gtest/gtest.h>

namespace onggi::measure::bill_plot_test {
namespace {

TEST(bill_plot, has_a_row_for_each_line_and_says_when_times_cannot_be_believed) {
  tuning::SceneBill bill;
  bill.whole_us = 10.0;
  bill.lines = {{"walls", "", 3.0}, {"tear_strain", "walls", 1.0}, {"moisture", "", -0.4}};
  const plots::BillSheet sheet = sheet_of(bill);
  ASSERT_EQ(sheet.rows.size(), 3u);
  EXPECT_EQ(sheet.rows[0].name, "walls");
  EXPECT_EQ(sheet.rows[1].name, "   tear_strain");
  EXPECT_EQ(sheet.subtitle.find("Do not believe"), std::string::npos);
  bill.lines[2].us = -2.5;
  EXPECT_NE(sheet_of(bill).subtitle.find("Do not believe these times"), std::string::npos);
}

}  // namespace
}  // namespace onggi::measure::bill_plot_test
