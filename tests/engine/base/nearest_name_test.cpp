#include "engine/base/nearest_name.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>
#include <string_view>
#include <vector>

namespace onggi::nearest_name_test {
namespace {

const std::vector<std::string> kNothing, kHeight{"height"};

TEST(nearest_name, swaps_case_and_hyphens_are_small_slips) {
  const std::vector<std::string> names{"height", "warn_after", "rows"};
  EXPECT_EQ(nearest_name("hieght", names), "height");
  EXPECT_EQ(nearest_name("Warn-After", names), "warn_after");
  EXPECT_EQ(nearest_name("row", names), "rows");
  EXPECT_EQ(nearest_name("colour", names), "");
  EXPECT_EQ(nearest_name("", names), "");
  EXPECT_EQ(nearest_name("x", kNothing), "");
}

TEST(nearest_name, a_name_is_nearest_to_itself_and_two_slips_in_six_letters_are_too_many_for_five) {
  EXPECT_TRUE(rc::check([](std::string word) {
    if (word.empty() || word.size() > 60) return;
    RC_ASSERT(nearest_name(word, std::vector<std::string>{"zzzzzzzzzzzzzzzzzzzz", word}) == word);
  }));
  EXPECT_EQ(nearest_name("hxigxt", kHeight), "height");
  EXPECT_EQ(nearest_name("hxixt", kHeight), "");
}

TEST(nearest_name, of_two_that_are_equally_near_the_first_is_meant) {
  const std::string_view names[] = {"pull_tall", "collar", "dollar"};
  EXPECT_EQ(nearest_name("xollar", names), "collar");
  EXPECT_EQ(nearest_name("PULL-TALL", names), "pull_tall");
}

TEST(nearest_name, names_are_joined_with_commas) {
  EXPECT_EQ(joined(std::vector<std::string>{"rib", "loop", "wire"}), "rib, loop, wire");
  EXPECT_EQ(joined(std::vector<std::string>{}), "");
}

}  // namespace
}  // namespace onggi::nearest_name_test
