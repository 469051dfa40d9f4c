#include "kiosk/collection/changes/draft.h"

#include <gtest/gtest.h>

namespace onggi::changes::draft_test {
namespace {

const fields::FieldList kList{
    "a.toml",
    {{.key = "credit"},
     {.table = "idle", .key = "warn_after", .kind = fields::FieldKind::number},
     {.table = "phone",
      .key = "port",
      .kind = fields::FieldKind::whole,
      .restarts_console = true}}};
const char* const kText = "credit = \"A\"  # who\n[idle]\nwarn_after = 60\n";

TEST(draft, holds_the_changed_text_and_tells_each_value) {
  Draft draft{kText, {}, false};
  ASSERT_TRUE(make_change(draft, &kList, {"credit", "B"}, "a.toml"));
  ASSERT_TRUE(make_change(draft, &kList, {"idle.warn_after", "60"}, "a.toml"));  // as it is
  ASSERT_TRUE(make_change(draft, &kList, {"idle.warn_after", std::nullopt}, "a.toml"));
  EXPECT_EQ(draft.text, "credit = \"B\"  # who\n");
  ASSERT_EQ(draft.values.size(), 2u);
  EXPECT_EQ(draft.values[0].is, "\"B\"");
  EXPECT_EQ(draft.values[1].was, "60");
  EXPECT_EQ(draft.values[1].is, "");
  EXPECT_FALSE(draft.restarts_console);
  ASSERT_TRUE(make_change(draft, &kList, {"phone.port", "8080"}, "a.toml"));
  EXPECT_TRUE(draft.restarts_console);
}

TEST(draft, stays_as_it_was_where_a_change_is_refused) {
  Draft draft{kText, {}, false};
  EXPECT_FALSE(make_change(draft, &kList, {"idle.warn_after", "soon"}, "a.toml"));
  EXPECT_FALSE(make_change(draft, &kList, {"idle.warn", "60"}, "a.toml"));
  EXPECT_FALSE(make_change(draft, &kList, {"idle warn", "60"}, "a.toml"));
  EXPECT_EQ(draft.text, kText);
  EXPECT_TRUE(draft.values.empty());
}

TEST(draft, knows_the_line_of_a_key) {
  EXPECT_EQ(line_of_key(kText, "a.toml", "idle.warn_after"), "a.toml:3:");
  EXPECT_EQ(line_of_key(kText, "a.toml", "idle.countdown"), "");
}

const fields::FieldList kTables{"a.toml",
                                {{.table = "slump", .key = "density"},
                                 {.table = "mission", .key = "id"},
                                 {.table = "mission", .key = "kind"}},
                                {{.name = "slump"}, {.name = "mission", .is_list = true}}};

TEST(draft, adds_a_table_and_what_stands_in_it_in_one_change) {
  Draft draft{"[[mission]]\nid = \"a\"\n", {}, false};
  for (const Change& change :
       {Change{"slump", kNewTable}, Change{"slump.density", "1900"}, Change{"mission.b", kNewTable},
        Change{"mission.b.kind", "today"}, Change{"slump", kNewTable}})
    ASSERT_TRUE(make_change(draft, &kTables, change, "a.toml")) << change.key;
  EXPECT_EQ(draft.text,
            "[[mission]]\nid = \"a\"\n\n[slump]\ndensity = \"1900\"\n\n[[mission]]\nid = "
            "\"b\"\nkind = \"today\"\n");
  ASSERT_EQ(draft.values.size(), 4u);  // the second slump was there
  EXPECT_EQ(draft.values[0].is, kNewTable);
  EXPECT_TRUE(draft.values[0].is_table);
  EXPECT_EQ(line_of_key(draft.text, "a.toml", "mission.b"), "a.toml:7:");
  EXPECT_EQ(line_of_key(draft.text, "a.toml", "slump"), "a.toml:4:");
}

TEST(draft, takes_a_table_out_and_remembers_all_of_it) {
  Draft draft{"a = 1\n\n# why\n[slump]\ndensity = 5\n", {}, false};
  ASSERT_TRUE(make_change(draft, &kTables, {"slump", std::nullopt}, "a.toml"));
  EXPECT_EQ(draft.text, "a = 1\n");
  EXPECT_EQ(draft.values.at(0).was, "# why\n[slump]\ndensity = 5\n");
  ASSERT_TRUE(make_change(draft, &kTables, {"slump", std::nullopt}, "a.toml"));
  EXPECT_EQ(draft.values.size(), 1u);  // it is out
  const auto wrong = make_change(draft, &kTables, {"slump", "5"}, "a.toml");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().what, "slump is a table, not a value.");
}

TEST(draft, means_an_element_that_goes_by_its_id_and_leaves_one) {
  Draft draft{"[[mission]]\nid = \"a\"\n[[mission]]\nid = \"b\"\n", {}, false};
  const auto numbered = make_change(draft, &kTables, {"mission.1", std::nullopt}, "a.toml");
  ASSERT_FALSE(numbered);
  EXPECT_EQ(numbered.error().remedy, "Write its id: mission.a.");
  EXPECT_TRUE(make_change(draft, &kTables, {"mission.a", std::nullopt}, "a.toml"));
  EXPECT_FALSE(make_change(draft, &kTables, {"mission.b", std::nullopt}, "a.toml"));
  EXPECT_EQ(draft.text, "[[mission]]\nid = \"b\"\n");
}

TEST(tag_of, is_the_bytes_own) {
  EXPECT_EQ(tag_of(kText), tag_of(kText));
  EXPECT_NE(tag_of("a = 60"), tag_of("a = 90"));
  EXPECT_NE(tag_of("a = 1"), tag_of("a = 1\n"));
}

}  // namespace
}  // namespace onggi::changes::draft_test
