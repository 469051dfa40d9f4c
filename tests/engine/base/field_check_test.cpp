#include "engine/base/field_check.h"

#include <gtest/gtest.h>

#include <limits>

namespace onggi {
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

TEST(FieldCheck, NotANumberIsOutsideEveryRange) {
  for (double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    FieldCheck check("");
    check.range("x", bad, -1e300, 1e300, "m");
    EXPECT_FALSE(check.result());
  }
}

}  // namespace
}  // namespace onggi
