#include "kiosk/lab/measure/naive_table.h"

#include <gtest/gtest.h>

namespace onggi::measure::naive_table_test {
namespace {

HeadlessOutcome made(const std::string& vessel, double points, double roughness,
                     std::optional<double> handsome_at) {
  HeadlessOutcome one;
  one.vessel = vessel;
  one.handsome_at = handsome_at;
  one.looks = {{30, points / 2, 1, {roughness, 0.001}, 0.0004},
               {90, points, points > 97 ? 5 : 4, {roughness, 0.001}, 0.0002}};
  return one;
}

TEST(NaiveTable, TellsTheMiddleTheLeastAndWhoBecameHandsomeInTime) {
  const std::vector<NaiveLine> lines =
      lines_of({made("bowl", 60, 0.001, 40), made("bowl", 98, 0.0002, 20),
                made("bowl", 80, 0.0004, {}), made("jar", 90, 0.0003, 10)},
               {30, 90});
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0].vessel, "bowl");
  EXPECT_EQ(lines[0].seconds, 30);
  EXPECT_EQ(lines[0].points, 40);
  EXPECT_EQ(lines[0].handsome, 1) << "the other came to it after 40 s";
  EXPECT_EQ(lines[3].points, 80);
  EXPECT_EQ(lines[3].least_points, 60);
  EXPECT_EQ(lines[3].roughness, 0.0004);
  EXPECT_EQ(lines[3].out_of_round, 0.0002);
  EXPECT_EQ(lines[3].five_stars, 1);
  EXPECT_EQ(lines[3].handsome, 2);
  EXPECT_EQ(lines[3].handsome_at, 30) << "of an even number the mean of the two in the middle";
  EXPECT_EQ(lines[5].vessel, "all");
  EXPECT_EQ(lines[5].visits, 4);
  EXPECT_EQ(lines[5].points, 85);
}

}  // namespace
}  // namespace onggi::measure::naive_table_test
