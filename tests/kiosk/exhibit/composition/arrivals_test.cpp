#include "kiosk/exhibit/composition/arrivals.h"

#include <gtest/gtest.h>

namespace onggi::exhibit::arrivals_test {
namespace {

Arrivals::Read vessel(const std::string& id) {
  std::vector<content::Vessel> one(1);
  one[0].id = id;
  return one;
}

std::string ids(const std::vector<Arrivals::Read>& taken) {
  std::string out;
  for (const Arrivals::Read& read : taken) out += read ? read->front().id : "!";
  return out;
}

TEST(Arrivals, come_in_the_order_of_the_shelf_whoever_is_read_first) {
  Arrivals arrivals;
  arrivals.begins(0, 3, "a");
  arrivals.has_read(1, vessel("b"));
  EXPECT_EQ(ids(arrivals.take(10.0)), "");
  arrivals.has_read(0, vessel("a"));
  EXPECT_EQ(ids(arrivals.take(10.5)), "ab");
  EXPECT_FALSE(arrivals.over());
  arrivals.has_read(2, problem("c", "broken.", "mend it."));
  arrivals.finish();
  EXPECT_FALSE(arrivals.over());
  EXPECT_EQ(ids(arrivals.take(10.6)), "!");
  EXPECT_TRUE(arrivals.over());
}

TEST(Arrivals, nobody_waits_long_for_a_slow_one_and_none_is_lost) {
  Arrivals arrivals;
  arrivals.begins(0, 4, "a");
  arrivals.has_read(1, vessel("b"));
  EXPECT_EQ(ids(arrivals.take(100.0)), "");
  arrivals.has_read(3, vessel("d"));
  EXPECT_EQ(ids(arrivals.take(100.0 + 0.9 * Arrivals::kPatience)), "");
  EXPECT_EQ(ids(arrivals.take(100.0 + Arrivals::kPatience)), "bd");
  EXPECT_EQ(arrivals.progress().done, 2);
  EXPECT_EQ(arrivals.progress().total, 4);
  arrivals.has_read(2, vessel("c"));
  EXPECT_EQ(ids(arrivals.take(103.0)), "");
  arrivals.has_read(0, vessel("a"));
  EXPECT_EQ(ids(arrivals.take(103.1)), "ac");
}

TEST(Arrivals, at_the_end_nothing_is_held_back) {
  Arrivals arrivals;
  arrivals.begins(0, 2, "a");
  arrivals.has_read(1, vessel("b"));
  arrivals.finish();
  EXPECT_EQ(ids(arrivals.take(0.0)), "b");
  EXPECT_TRUE(arrivals.over());
}

}  // namespace
}  // namespace onggi::exhibit::arrivals_test
