#include "kiosk/watch/health.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

namespace onggi::watch {
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
  EXPECT_THAT(one_line(health), HasSubstr("the disk takes no writes"));
}

}  // namespace
}  // namespace onggi::watch
