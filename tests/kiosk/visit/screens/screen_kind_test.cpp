#include "kiosk/visit/screens/screen_kind.h"

#include <gtest/gtest.h>

#include <set>

namespace onggi::screens::screen_kind_test {
namespace {

TEST(ScreenKinds, StandInTheOrderOfAVisitEachByItsOwnName) {
  std::set<std::string_view> names;
  for (std::size_t n = 0; n < screen_kinds().size(); ++n) {
    const ScreenKind& kind = screen_kinds()[n];
    EXPECT_EQ(static_cast<std::size_t>(kind.id), n) << kind.name;
    EXPECT_EQ(&kind_of(kind.id), &kind);
    EXPECT_EQ(name_of(kind.id), kind.name);
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_NE(kind.make, nullptr) << kind.name;
  }
  EXPECT_EQ(screen_kinds().back().id, ScreenId::fault) << "the last of ScreenId";
}

}  // namespace
}  // namespace onggi::screens::screen_kind_test
