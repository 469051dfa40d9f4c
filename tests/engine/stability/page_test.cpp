#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>

namespace onggi::stability::page_test {
namespace {

// The cases that engine/docs/stability.md lists, by their names in backticks.
std::set<std::string> listed() {
  std::ifstream page("engine/docs/stability.md");
  EXPECT_TRUE(page) << "tests run in the project's root";
  std::set<std::string> names;
  bool within = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("## ", 0) == 0) within = line == "## The cases";
    if (!within || line.rfind("| `", 0) != 0) continue;
    names.insert(line.substr(3, line.find('`', 3) - 3));
  }
  return names;
}

TEST(Page, NamesEveryCaseAndNoOther) {
  std::set<std::string> cases;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int n = 0; n < all.total_test_suite_count(); ++n) {
    const testing::TestSuite& suite = *all.GetTestSuite(n);
    for (int k = 0; k < suite.total_test_count(); ++k)
      cases.insert(std::string(suite.name()) + "." + suite.GetTestInfo(k)->name());
  }
  EXPECT_EQ(cases, listed());
}

}  // namespace
}  // namespace onggi::stability::page_test
