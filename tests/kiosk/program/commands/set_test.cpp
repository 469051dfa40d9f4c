#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/kiosk/exhibit/editing/small_site.h"
#include "tests/kiosk/program/commands/program.h"

namespace onggi::commands::set_test {
namespace {

using editing::test::replaced;
using editing::test::SmallSite;
using ::nlohmann::json;

Outcome in(const SmallSite& site, const std::string& arguments) {
  return onggi(arguments, "cd '" + site.path().string() + "'");
}

void expect_in(const std::string& words, const std::string& text) {
  EXPECT_NE(text.find(words), std::string::npos) << words << "\n is not in\n" << text;
}

TEST(set_command, a_curator_changes_a_value_looks_at_it_and_takes_it_back) {
  const SmallSite site;
  const std::string before = content(site.exhibit());
  const Outcome set =
      in(site, "set config/exhibit.toml credit 'Museum of Clay' idle.warn_after 90");
  EXPECT_EQ(set.exit_code, 0) << set.err;
  expect_in("config/exhibit.toml: credit is \"Museum of Clay\" now. It was \"Onggi\".\n", set.out);
  expect_in("config/exhibit.toml: idle.warn_after is 90 now. It was 60.\n", set.out);
  expect_in("To take it back: onggi undo\n", set.out);
  EXPECT_EQ(content(site.exhibit()),
            replaced(replaced(before, "\"Onggi\" ", "\"Museum of Clay\" "), "= 60 ", "= 90 "));
  const Outcome list = in(site, "undo --list");
  expect_in("  credit: \"Onggi\" -> \"Museum of Clay\"\n  idle.warn_after: 60 -> 90\n", list.out);
  expect_in("1. 20", list.out);
  const Outcome undo = in(site, "undo");
  EXPECT_EQ(undo.exit_code, 0) << undo.err;
  expect_in("idle.warn_after is 60 again. It was 90 since 20", undo.out);
  EXPECT_EQ(content(site.exhibit()), before);
  const Outcome empty = in(site, "undo");
  EXPECT_EQ(empty.exit_code, 2);
  expect_in("There is no change to take back.", empty.err);
  expect_in("nothing to undo", in(site, "undo --list").out);
}

TEST(set_command, a_slip_is_told_with_what_to_do_and_changes_nothing) {
  const SmallSite site;
  const auto before = site.texts();
  for (const auto& [arguments, what] :
       {std::pair{"config/exhibit.toml idle.warn_aftr 90", "Did you mean idle.warn_after?"},
        {"config/exhibit.toml idle.warn_after", "The key idle.warn_after has no value."},
        {"config/exhibit.toml credit Museum of Clay", "A value with spaces stands in quotes"},
        {"config/exhibit.toml idle.warn_after 5", "config/exhibit.toml:28:14: "},
        {"config/exhibit.toml idle.warn_after 1,5", "A part of one has a point: 1.5."},
        {"config/exhibt.toml idle.warn_after 90", "There is no such file."},
        {"config/exhibit.toml sound.volume -1", "the smallest allowed value is 0"},
        {"config/exhibit.toml", "No key is named."}}) {
    const Outcome slip = in(site, std::string("set ") + arguments);
    EXPECT_EQ(slip.exit_code, 2) << arguments;
    EXPECT_EQ(slip.out, "");
    expect_in(what, slip.err);
  }
  EXPECT_EQ(site.texts(), before);
}

// The library that reads the command line would split the list, and take its brackets away.
TEST(set_command, brackets_quotes_and_a_minus_arrive_as_they_were_typed) {
  const SmallSite site;
  const Outcome list = in(site,
                          "set config/exhibit.toml languages '[\"en\", \"ko\", \"de\"]' title.de "
                          "'[Ein Topf]' credit 'it\"s \\ ours'");
  EXPECT_EQ(list.exit_code, 0) << list.err;
  const std::string text = content(site.exhibit());
  expect_in("languages = [\"en\", \"ko\", \"de\"] ", text);
  expect_in("de = \"[Ein Topf]\"\n", text);
  expect_in("credit = \"it\\\"s \\\\ ours\" ", text);
  const Outcome minus = in(site, "set config/devices/polhem.toml arm.parked '[-5, 0, 100]'");
  EXPECT_EQ(minus.exit_code, 0) << minus.err;
  EXPECT_EQ(in(site, "set config/devices/polhem.toml arm.parked -5,0,101").exit_code, 0);
  expect_in("parked = [-5,0,101] ", content(site / "config/devices/polhem.toml"));
}

TEST(set_command, an_empty_value_is_a_value) {
  const SmallSite site;
  EXPECT_EQ(in(site, "set config/exhibit.toml order ''").exit_code, 0);
  expect_in("order = [] ", content(site.exhibit()));
}

TEST(check_command, tells_programs_every_problem_with_file_line_and_column) {
  const SmallSite site;
  site.by_hand("config/exhibit.toml", "warn_after = 60", "warn_after = 5");
  const Outcome run = in(site, "check --json -");
  EXPECT_EQ(run.exit_code, 2);
  const json report = json::parse(run.out);
  EXPECT_FALSE(report["good"]);
  ASSERT_EQ(report["problems"].size(), 1u);
  const json& problem = report["problems"][0];
  expect_in("config/exhibit.toml", problem["file"]);
  EXPECT_EQ(problem["line"], 28);
  EXPECT_EQ(problem["column"], 14);
  expect_in("smallest allowed value is 20 s", problem["what"]);
  expect_in("Write a number", problem["remedy"]);
  const Outcome good =
      onggi("check --json - '" + (site / "config/scenes/studio.toml").string() + "'");
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_TRUE(json::parse(good.out)["good"]);
}

TEST(check_command, shows_every_key_to_people_and_to_programs) {
  const Outcome words = onggi("check --fields");
  EXPECT_EQ(words.exit_code, 0);
  expect_in("  idle.warn_after: s, 20 to 3600 [60]\n      time without a touch", words.out);
  const json lists = json::parse(onggi("check --fields --json -").out);
  EXPECT_EQ(lists[0]["file"], "exhibit.toml");
  bool found = false;
  for (const json& field : lists[0]["fields"])
    if (field["table"] == "keepsake" && field["key"] == "quota_mb") {
      found = true;
      EXPECT_EQ(field["kind"], "whole");
      EXPECT_EQ(field["least"], 10);
      EXPECT_EQ(field["most"], 1'000'000);
      EXPECT_EQ(field["unit"], "MB");
      EXPECT_EQ(field["default"], "2000");
    }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace onggi::commands::set_test
