#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/support/engine_trace.h"

namespace onggi {
namespace {

// The hash after every second is kept in tests/golden. A changed hash means that old replays no
// longer replay: say why where you change the file. tests/determinism runs the same trace from
// other compilers.
TEST(Golden, ATraceOfTheTickHasTheSameBitsOnEveryMachineAndCompiler) {
  std::ifstream file("tests/golden/engine_trace.txt");
  ASSERT_TRUE(file) << "tests run in the project's root";
  std::ostringstream golden;
  golden << file.rdbuf();
  EXPECT_EQ(engine_trace(), golden.str());
}

}  // namespace
}  // namespace onggi
