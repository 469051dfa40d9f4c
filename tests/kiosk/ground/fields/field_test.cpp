#include "kiosk/ground/fields/field.h"

#include <gtest/gtest.h>

namespace onggi::fields::field_test {
namespace {

const FieldList kList{
    "test.toml",
    {{.table = "",
      .key = "credit",
      .words = "a name",
      .range = "1 to 120 letters",
      .usual = "\"O\""},
     {.table = "idle",
      .key = "warn_after",
      .kind = FieldKind::number,
      .words = "a wait",
      .least = 20,
      .most = 3600,
      .unit = "s",
      .usual = "60",
      .page = "kiosk/docs/a_visit.md"},
     {.table = "idle", .key = "rows", .kind = FieldKind::whole, .words = "rows", .most = 20000},
     {.table = "step", .key = "until", .words = "its end", .choices = {"opened", "touched"}},
     {.table = "screen",
      .key = "spoken",
      .kind = FieldKind::boolean,
      .words = "it speaks",
      .restarts_console = true},
     {.table = "label.LANGUAGE", .key = "title", .words = "the name"},
     {.table = "step.words", .key = "LANGUAGE", .words = "the words", .any_key = true}}};

TEST(field, tells_what_is_allowed_by_its_kind) {
  const auto allowed = [](std::size_t n) { return allowed_range(kList.fields[n]); };
  EXPECT_EQ(allowed(0), "1 to 120 letters");
  EXPECT_EQ(allowed(1), "s, 20 to 3600");
  EXPECT_EQ(allowed(2), "0 to 20000");
  EXPECT_EQ(allowed(3), "`\"opened\"`, `\"touched\"`");
  EXPECT_EQ(allowed(4), "true or false");
}

TEST(field, is_a_row_of_the_page) {
  EXPECT_EQ(page_row(kList.fields[0]), "| `credit` | a name | 1 to 120 letters | `\"O\"` |");
  EXPECT_EQ(page_row(kList.fields[1]),
            "| `warn_after` | a wait ([a visit](../kiosk/docs/a_visit.md)) | s, 20 to 3600 | 60 |");
  EXPECT_EQ(
      page_row(kList.fields[4]),
      "| `spoken` | it speaks; start onggi-console again after a change | true or false |  |");
}

TEST(field, is_found_by_its_names_and_by_any_key_of_an_open_table) {
  EXPECT_EQ(find_field(kList, {"credit"}), &kList.fields[0]);
  EXPECT_EQ(find_field(kList, {"idle", "warn_after"}), &kList.fields[1]);
  EXPECT_EQ(find_field(kList, {"step", "words", "ko"}), &kList.fields[6]);
  EXPECT_EQ(find_field(kList, {"label", "ko", "title"}), &kList.fields[5]);
  EXPECT_EQ(find_field(kList, {"step", "words"}), nullptr);
  EXPECT_EQ(find_field(kList, {"warn_after"}), nullptr);
  EXPECT_EQ(find_field(kList, {}), nullptr);
}

TEST(field, that_is_wrong_leads_to_the_right_one) {
  EXPECT_EQ(right_key(kList, "idle.warn_aftr"), "Did you mean idle.warn_after?");
  EXPECT_EQ(right_key(kList, "warn_after"), "Did you mean idle.warn_after?");
  EXPECT_EQ(right_key(kList, "screen.warn_after"), "Did you mean idle.warn_after?");
  EXPECT_EQ(right_key(kList, "warn-aftr"), "Did you mean idle.warn_after?");
  EXPECT_EQ(right_key(kList, "idle"), "It is a table. Name one of its keys: idle.warn_after.");
  EXPECT_EQ(right_key(kList, "label.fr.titel"), "Did you mean label.fr.title?");
  EXPECT_EQ(right_key(kList, "zebra"), "onggi check --fields shows every key.");
}

}  // namespace
}  // namespace onggi::fields::field_test
