#include "engine/base/field_check.h"

#include <gtest/gtest.h>

#include <limits>

namespace onggi::field_check_test {
namespace {

TEST(FieldCheck, NamesTheFirstWrongFieldItsMeaningAndARemedy) {
  FieldCheck check("clay");
  check.range("height", 0.2, 0.01, 1.0, "m");
  check.range("rows", 4, 8, 20000, "");
  check.range("sectors", -1, 16, 8192, "");
  const Result<void> result = check.result();
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().where, "clay.rows");
  EXPECT_EQ(result.error().what, "clay.rows is 4, outside 8 to 20000.");
  EXPECT_EQ(result.error().remedy, "Write a number from 8 to 20000.");
}

TEST(FieldCheck, a_value_just_beyond_its_bound_is_told_with_the_digits_that_differ) {
  const auto told = [](double value) {
    FieldCheck check("slump");
    check.range("yield_stress", value, 100, 1e6, "Pa");
    return check.result().error().what;
  };
  EXPECT_EQ(told(1000000.5), "slump.yield_stress is 1000000.5 Pa, outside 100 to 1e+06 Pa.");
  EXPECT_EQ(told(99.9999999),
            "slump.yield_stress is 99.999999900000006 Pa, outside 100 to 1e+06 Pa.");
}

TEST(FieldCheck, NotANumberIsOutsideEveryRange) {
  for (double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    FieldCheck check("");
    check.range("x", bad, -1e300, 1e300, "m");
    EXPECT_FALSE(check.result());
  }
}

}  // namespace
}  // namespace onggi::field_check_test
