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
      "\"restarts_console\":false}]}");
}

TEST(field_json, tells_people_without_marks) {
  EXPECT_EQ(text_of(kOne),
            "a.toml\n  idle.countdown: s, 20 to 300 [25]\n      how long it waits\n");
}

}  // namespace
}  // namespace onggi::fields::field_json_test
