#include "kiosk/ground/files/json.h"

#include <gtest/gtest.h>

#include <limits>

namespace onggi::files::json_test {
namespace {

TEST(Json, members_keep_their_order_and_a_member_named_twice_is_one) {
  Json pot = Json::object({{"vessel", "moon_jar"}, {"height", 0.305}});
  pot["ticks"] = 60000u;
  pot["vessel"] = "bowl";
  EXPECT_EQ(pot.text(-1), R"({"vessel":"bowl","height":0.305,"ticks":60000})");
}

TEST(Json, every_kind_of_value_is_written_as_it_is) {
  const Json all = Json::list({Json(), true, -1, std::numeric_limits<std::uint64_t>::max(), 1.0,
                               "달항아리", std::string("a\"\n"), Json::object(), Json::list()});
  EXPECT_EQ(all.text(-1),
            "[null,true,-1,18446744073709551615,1.0,\"달항아리\",\"a\\\"\\n\",{},[]]");
}

TEST(Json, lines_are_indented_and_a_list_of_anything_is_a_list) {
  const std::vector<std::string> words{"a", "b"};
  EXPECT_EQ(Json::object({{"words", Json::list_of(words)}}).text(2),
            "{\n  \"words\": [\n    \"a\",\n    \"b\"\n  ]\n}");
}

TEST(Json, what_is_no_number_is_null_and_what_is_no_utf8_is_mended) {
  EXPECT_EQ(Json(std::numeric_limits<double>::quiet_NaN()).text(-1), "null");
  EXPECT_EQ(Json("a\xff").text(-1), "\"a\xEF\xBF\xBD\"");
}

}  // namespace
}  // namespace onggi::files::json_test
