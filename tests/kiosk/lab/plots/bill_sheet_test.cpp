#include "kiosk/lab/plots/bill_sheet.h"

#include <gtest/gtest.h>

#include <string>

namespace onggi::plots::bill_sheet_test {
namespace {

TEST(BillSheet, ALineMoreMakesItHigherAndWhatIsLessThanNothingHasNoBar) {
  BillSheet bill{"title", "subtitle", "foot", {"us", "mm", "N"}, {{"walls", {2.0, 0.1, 0.01}}}};
  const auto svg = [&] {
    const auto bytes = draw_bill(bill, "a.svg");
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  const std::string one = svg();
  EXPECT_NE(one.find("height=\"404"), std::string::npos) << one.substr(0, 300);
  bill.rows.push_back({"volume", {-1.0, 0.0, 0.0}});
  const std::string two = svg();
  EXPECT_NE(two.find("height=\"468"), std::string::npos) << two.substr(0, 300);
  EXPECT_EQ(two.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace onggi::plots::bill_sheet_test
