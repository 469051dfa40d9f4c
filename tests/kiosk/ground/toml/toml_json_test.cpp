#include "kiosk/ground/toml/toml_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace onggi::toml::toml_json_test {
namespace {

TEST(toml_json, has_every_value_under_its_own_name) {
  const auto text = json_of(
      "credit = \"한 \\\"x\\\"\"\nn = 1.5\nlist = [\"a\"]\n[hours]\n\"12-25\" = \"closed\"\n"
      "[[step]]\nid = \"open\"\non = true\n");
  ASSERT_TRUE(text);
  const auto json = nlohmann::json::parse(*text);
  EXPECT_EQ(json["credit"], "한 \"x\"");
  EXPECT_EQ(json["n"], 1.5);
  EXPECT_EQ(json["list"][0], "a");
  EXPECT_EQ(json["hours"]["12-25"], "closed");
  EXPECT_EQ(json["step"][0]["on"], true);
}

TEST(toml_json, of_what_is_no_toml_is_nothing) {
  EXPECT_FALSE(json_of("a = "));
  EXPECT_FALSE(json_of("größe = 1"));
  EXPECT_EQ(json_of(""), "{}");
}

}  // namespace
}  // namespace onggi::toml::toml_json_test
