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

TEST(tag_of, is_the_bytes_own) {
  EXPECT_EQ(tag_of(kText), tag_of(kText));
  EXPECT_NE(tag_of("a = 60"), tag_of("a = 90"));
  EXPECT_NE(tag_of("a = 1"), tag_of("a = 1\n"));
}

}  // namespace
}  // namespace onggi::changes::draft_test
