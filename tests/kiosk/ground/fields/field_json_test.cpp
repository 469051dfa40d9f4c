#include "kiosk/ground/fields/field_json.h"

#include <gtest/gtest.h>

namespace onggi::fields::field_json_test {
namespace {

const FieldList kOne{"a.toml",
                     {{.table = "idle",
                       .key = "countdown",
                       .kind = FieldKind::number,
                       .words = "how long `it` waits",
                       .least = 20,
                       .most = 300,
                       .unit = "s",
                       .usual = "25"}}};

TEST(field_json, tells_programs_bounds_as_numbers) {
  EXPECT_EQ(
      json_of(kOne).text(-1),
      "{\"file\":\"a.toml\",\"fields\":[{\"table\":\"idle\",\"key\":\"countdown\",\"kind\":"
      "\"number\",\"words\":\"how long `it` waits\",\"allowed\":\"s, 20 to 300\",\"least\":20."
      "0,\"most\":300.0,\"unit\":\"s\",\"default\":\"25\",\"any_key\":false,"
      "\"restarts_console\":false}],\"tables\":[]}");
}

TEST(field_json, tells_people_without_marks) {
  EXPECT_EQ(text_of(kOne),
            "a.toml\n  idle.countdown: s, 20 to 300 [25]\n      how long it waits\n");
}

TEST(field_json, tells_which_tables_a_file_may_do_without) {
  const FieldList list{
      "a.toml",
      {},
      {{.name = "slump", .words = "It sags.", .gives = "It falls.", .needs = "volume"},
       {.name = "mission", .is_list = true, .words = "A task."}}};
  EXPECT_EQ(json_of(list).text(-1),
            "{\"file\":\"a.toml\",\"fields\":[],\"tables\":[{\"name\":\"slump\",\"is_list\":false,"
            "\"words\":\"It sags.\",\"gives\":\"It falls.\",\"needs\":\"volume\"},{\"name\":"
            "\"mission\",\"is_list\":true,\"words\":\"A task.\"}]}");
  EXPECT_EQ(text_of(list),
            "a.toml\n  [slump], may be left out\n      It sags.\n  [[mission]]\n      A task.\n");
}

}  // namespace
}  // namespace onggi::fields::field_json_test
