#include "engine/lab/witness.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace onggi::lab::witness_test {
namespace {

std::vector<Witness> all() {
  std::vector<Witness> laws;
  for (const WitnessFamily& family : witness_families())
    laws.insert(laws.end(), family.witnesses.begin(), family.witnesses.end());
  return laws;
}

class Law : public testing::TestWithParam<Witness> {};

TEST_P(Law, HoldsAgainstItsWitness) {
  const Witness& law = GetParam();
  EXPECT_LE(law.measure(0.0), law.bound) << law.law << ", against " << law.against;
}

// A witness that cannot fail is none.
TEST_P(Law, ThatIsFivePercentOffIsNoticed) {
  const Witness& law = GetParam();
  EXPECT_FALSE(law.holds(law.measure(0.05))) << law.law << ", with another " << law.altered;
}

INSTANTIATE_TEST_SUITE_P(Of, Law, testing::ValuesIn(all()), [](const auto& with) {
  std::string name;
  bool begins = true;
  for (const char c : with.param.law) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      name += begins ? static_cast<char>(std::toupper(c)) : c;
    begins = std::isalnum(static_cast<unsigned char>(c)) == 0;
  }
  return name;
});

TEST(Witnesses, NaNNeverHolds) {
  const Witness law{"", "", "", 1.0, "", nullptr};
  EXPECT_TRUE(law.holds(1.0));
  EXPECT_FALSE(law.holds(1.1));
  EXPECT_FALSE(law.holds(std::nan("")));
}

TEST(Witnesses, StandOnTheirPageWithTheirBounds) {
  std::ifstream file("engine/docs/witness.md");
  ASSERT_TRUE(file) << "tests run in the project's root";
  std::set<std::string> listed, wanted;
  for (std::string line; std::getline(file, line);) {
    if (!line.ends_with("| holds |")) continue;
    // All but the figure that was measured: | law | against | apart | bound | holds |
    std::vector<std::string> cells;
    std::istringstream cut(line);
    for (std::string cell; std::getline(cut, cell, '|');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 6u) << line;
    listed.insert(cells[1] + "|" + cells[2] + "|" + cells[4]);
  }
  for (const Witness& law : all()) {
    std::ostringstream row;
    row.precision(2);
    row << ' ' << law.law << " | " << law.against << " | " << law.bound
        << (law.unit.empty() ? "" : " ") << law.unit << ' ';
    wanted.insert(row.str());
  }
  EXPECT_EQ(listed, wanted) << "write what onggi lab witness prints into engine/docs/witness.md";
}

}  // namespace
}  // namespace onggi::lab::witness_test
