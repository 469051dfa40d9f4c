#include "kiosk/wheel/device/device_fields.h"

#include <gtest/gtest.h>

#include "tests/kiosk/ground/fields/page_tables.h"

namespace onggi::device::device_fields_test {
namespace {

TEST(device_fields, have_words_and_a_row_each_on_the_page) {
  fields::test::expect_whole(device_fields());
  fields::test::expect_on_page(
      device_fields(), "## devices/KIND.toml", [](const std::string& table) {
        return table.empty() ? "## devices/KIND.toml" : "`[" + table + "]`";
      });
}

}  // namespace
}  // namespace onggi::device::device_fields_test
