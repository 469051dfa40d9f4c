#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/engine_trace.h"
#include "tests/support/hard_trace.h"
#include "tests/support/sanitized.h"

namespace onggi::golden_test {
namespace {

// Hashes are kept in tests/golden. A changed hash means that old replays no longer replay: say why
// where you change the file. tests/determinism runs the same traces from other compilers.
std::string golden(const std::string& name) {
  std::ifstream file("tests/golden/" + name);
  EXPECT_TRUE(file) << "tests run in the project's root";
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Golden, ATraceOfTheTickHasTheSameBitsOnEveryMachineAndCompiler) {
  EXPECT_EQ(engine_trace(), golden("engine_trace.txt"));
}

TEST(Golden, SoHasATraceOfEveryToolWithEveryEffectOnEveryKindOfVectors) {
  for (const Vectors kind : vectors_here())
    EXPECT_EQ(tools_trace(kind), golden("tools_trace.txt")) << name_of(kind);
}

TEST(Golden, SoHasATraceOfRandomHandsInRandomScenesOnEveryKindOfVectors) {
  for (const Vectors kind : vectors_here()) {
    // Under a sanitizer plain ones take two minutes; the other traces have been through it.
    if (ONGGI_SANITIZED != 0 && kind != best_vectors()) continue;
    EXPECT_EQ(hard_trace(kind), golden("hard_trace.txt")) << name_of(kind);
  }
}

TEST(Golden, SoHasWhatAForceDeviceIsGiven) {
  EXPECT_EQ(handle_trace(), golden("handle_trace.txt"));
}

}  // namespace
}  // namespace onggi::golden_test
