#include "kiosk/program/console/line_keys.h"

#include <gtest/gtest.h>

namespace onggi::console::line_keys_test {
namespace {

TEST(LineKeys, KnowWhatAProblemIsAbout) {
  const std::string text = "a = 1\n\n[t]\nb = \"\"\"\nx\n\"\"\"\nc = 2 # [no]\n[[m]]\nid = \"d\"\n";
  const LineKeys keys(text, "x.toml");
  const auto value = [&](const char* where) {
    const auto* found = keys.value_at({where, "", ""});
    return found == nullptr ? std::string() : found->path.back();
  };
  EXPECT_EQ(value("x.toml:1:5"), "a");
  EXPECT_EQ(value("x.toml:4:5"), "b");
  EXPECT_EQ(value("x.toml:7:1"), "c");
  EXPECT_EQ(value("x.toml:9:1"), "id");
  for (const char* none : {"x.toml:2:1", "x.toml:3:1", "y.toml:1:1", "x.toml", "", "x.toml:x",
                           "x.toml:99999999999999999999:1"})
    EXPECT_EQ(value(none), "") << none;
  EXPECT_EQ(keys.header_at({"x.toml:3:1", "", ""})->path, toml::Path{"t"});
  EXPECT_EQ(keys.header_at({"x.toml:8:1", "", ""})->path, (toml::Path{"m", "1"}));
  EXPECT_EQ(keys.header_at({"x.toml:1:1", "", ""}), nullptr);
}

}  // namespace
}  // namespace onggi::console::line_keys_test
