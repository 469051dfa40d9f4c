#include "kiosk/collection/changes/typed_value.h"

#include <gtest/gtest.h>

namespace onggi::changes::typed_value_test {
namespace {

/// What is written for `typed`, or the Problem's words.
std::string value(const std::string& typed, const fields::Field* field,
                  const std::string& was = "") {
  const auto done = typed_value(typed, field, was, "a.toml, key");
  return done ? *done : to_text(done.error());
}

TEST(typed_value, is_written_by_the_fields_kind) {
  const fields::Field text{.key = "t"}, list{.key = "l", .kind = fields::FieldKind::list},
      texts{.key = "n", .kind = fields::FieldKind::texts};
  EXPECT_EQ(value("Museum of Clay", &text), "\"Museum of Clay\"");
  EXPECT_EQ(value("true", &text), "\"true\"");
  EXPECT_EQ(value("'raw'", &text), "'raw'");
  EXPECT_EQ(value("'", &text), "\"'\"");
  EXPECT_EQ(value("", &text), "\"\"");
  EXPECT_EQ(value("a, b,", &texts), "[\"a\", \"b\"]");
  EXPECT_EQ(value("", &texts), "[]");
  EXPECT_EQ(value("[\"a\"]", &texts), "[\"a\"]");
  EXPECT_EQ(value("1, 2.5", &list), "[1, 2.5]");
}

TEST(typed_value, of_another_kind_is_refused_with_what_to_write) {
  const fields::Field number{
      .key = "n", .kind = fields::FieldKind::number, .least = 20, .most = 300, .unit = "s"},
      whole{.key = "w", .kind = fields::FieldKind::whole, .most = 9},
      boolean{.key = "b", .kind = fields::FieldKind::boolean};
  EXPECT_EQ(
      value("soon", &number),
      "a.toml, key: \"soon\" is not a number.\n  Write a number from 20 to 300 s, without the "
      "unit. A part of one has a point: 1.5.");
  EXPECT_EQ(value("2.5", &whole),
            "a.toml, key: \"2.5\" is not a whole number.\n  Write a whole number from 0 to 9, "
            "without the unit.");
  EXPECT_EQ(value("yes", &boolean),
            "a.toml, key: \"yes\" is not true or false.\n  Write true or false.");
  for (const char* wrong : {"nan", "inf", "", "1e999", "0x", "1 2", "1\nb = 2"})
    EXPECT_NE(value(wrong, &number).find("is not a number"), std::string::npos) << wrong;
}

TEST(typed_value, of_a_key_without_a_list_is_of_the_kind_that_stands_there) {
  EXPECT_EQ(value("46", nullptr, "\"old\""), "\"46\"");
  EXPECT_EQ(value("46", nullptr, "3.5"), "46");
  EXPECT_EQ(value("a,b", nullptr, "[\"x\"]"), "[\"a\", \"b\"]");
  EXPECT_NE(value("old", nullptr, "true").find("is not true or false"), std::string::npos);
  EXPECT_EQ(value("46", nullptr), "46");
  EXPECT_EQ(value("forty six", nullptr), "\"forty six\"");
}

TEST(typed_key, finds_elements_by_id_and_number_and_helps_with_a_slip) {
  const std::string text = "[[step]]\nid = \"touch\"\n[[step]]\nid = \"open\"\n[[bare]]\na = 1\n";
  const toml::TomlPlaces places(text);
  const auto shown = [&](const std::string& key) {
    const auto done = typed_key(text, places, key, "a.toml");
    return done ? done->shown + " " + toml::Path(done->path)[1] : to_text(done.error());
  };
  EXPECT_EQ(shown("step.open.after"), "step.open.after 2");
  EXPECT_EQ(shown("step.2.after"), "step.open.after 2");
  EXPECT_EQ(shown("bare.1.a"), "bare.1.a 1");
  EXPECT_NE(shown("step.opn.after").find("Did you mean step.open?"), std::string::npos);
  EXPECT_NE(shown("step.3.after").find("Write one of: touch, open."), std::string::npos);
  EXPECT_NE(shown("bare.x.a").find("Write a number from 1 to 1."), std::string::npos);
  EXPECT_NE(shown("a b").find("is not a key"), std::string::npos);
}

}  // namespace
}  // namespace onggi::changes::typed_value_test
