#include "kiosk/program/watch/health.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

namespace onggi::watch::health_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(health, every_line_is_prometheus_text_and_every_metric_has_help_and_type_and_one_value) {
  const std::regex value("(onggi_[a-z_]+)(\\{version=\"[^\"]*\"\\})? [0-9.e+-]+");
  const std::regex head("# (HELP|TYPE) (onggi_[a-z_]+) .+");
  std::multiset<std::string> helped, typed, valued;
  std::istringstream lines(prometheus_text({.version = "0.1.0", .worst_wake_s = 1e-5}));
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    if (std::regex_match(line, found, head))
      (found[1] == "HELP" ? helped : typed).insert(found[2]);
    else if (std::regex_match(line, found, value))
      valued.insert(found[1]);
    else
      ADD_FAILURE() << line;
  }
  EXPECT_GT(valued.size(), 10u);
  EXPECT_EQ(helped, valued);
  EXPECT_EQ(typed, valued);
  EXPECT_EQ(std::set<std::string>(valued.begin(), valued.end()).size(), valued.size());
}

TEST(health, counts_go_on_over_a_reload_and_large_ones_are_told_to_the_last_digit) {
  Health before, later;
  before.frames = 10;
  before.wakes = 1000;
  before.worst_wake_s = 0.002;
  before.kept = 3;
  later.safe_mode = true;
  later.running_s = 8640000.25;
  later.frames = 5;
  later.wakes = 30;
  later.worst_wake_s = 0.001;
  later.kept = later.not_kept = 1;
  const std::string text = prometheus_text(together(before, later));
  for (const char* line :
       {"onggi_frames_total 15", "onggi_loop_wakes_total 1030",
        "onggi_loop_worst_wake_seconds 0.002", "onggi_keepsakes_total 4",
        "onggi_keepsakes_failed_total 1", "onggi_safe_mode 1", "onggi_running_seconds 8640000.25"})
    EXPECT_THAT(text, HasSubstr("\n" + std::string(line)));
}

TEST(health, from_half_the_quota_on_it_tells_how_much_pages_for_phones_hold) {
  Health health;
  EXPECT_THAT(one_line(health), Not(HasSubstr("quota")));
  health.quota_bytes = 2'000'000'000;
  health.promised_bytes = 999'000'000;
  EXPECT_THAT(one_line(health), Not(HasSubstr("quota")));
  EXPECT_THAT(prometheus_text(health), HasSubstr("\nonggi_pages_promised_bytes 999000000\n"));
  EXPECT_THAT(prometheus_text(health), HasSubstr("\nonggi_keepsakes_quota_bytes 2000000000\n"));
  health.promised_bytes = 1'240'000'000;
  EXPECT_THAT(one_line(health), HasSubstr("pages for phones hold 62 % of the quota"));
}

TEST(health, it_tells_what_is_wrong) {
  Health health;
  EXPECT_THAT(prometheus_text(health), HasSubstr("\nonggi_safe_mode 0\n"));
  EXPECT_THAT(prometheus_text(health), HasSubstr("\nonggi_disk_writes 1\n"));
  EXPECT_THAT(one_line(health), Not(HasSubstr("disk")));
  health.safe_mode = true;
  health.disk_writes = false;
  health.crashes = 4;
  EXPECT_THAT(prometheus_text(health), HasSubstr("\nonggi_safe_mode 1\n"));
  EXPECT_THAT(prometheus_text(health), HasSubstr("\nonggi_disk_writes 0\n"));
  EXPECT_THAT(prometheus_text(health), HasSubstr("\nonggi_crashes_in_a_row 4\n"));
  EXPECT_THAT(one_line(health), HasSubstr("Safe mode"));
  EXPECT_THAT(one_line(health), HasSubstr("the disk cannot be written"));
}

}  // namespace
}  // namespace onggi::watch::health_test
