#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "engine/math/portable.h"
#include "engine/scene/scene.h"

namespace onggi {
namespace {

// Six seconds of a potter's work on a whole grid: outside, inside, water, both hands, a fault, a
// renewed lump, odd tick lengths. The hash after every second is kept in tests/golden. A changed
// hash means that old replays no longer replay: say why where you change the file.
TEST(Golden, ATraceOfTheTickHasTheSameBitsOnEveryMachineAndCompiler) {
  auto scene = Scene::create({});
  ASSERT_TRUE(scene);
  std::ostringstream hashes;
  Hands hands;
  hands.wheel_speed = 21.0;
  for (int n = 0; n < 6000; ++n) {
    const double t = n * 0.001;
    HandInput& out = hands.hand[0];
    HandInput& in = hands.hand[1];
    out.active = n % 2500 > 100;
    out.position = {0.064 - 0.006 * portable::sin(2.0 * t), 0.02 + 0.03 * t,
                    0.01 * portable::cos(3.0 * t)};
    in.active = n > 2200 && n < 4800;
    in.side = SideWish::inside;
    in.position = {-0.012 - 0.004 * (t - 2.0), 0.15 - 0.02 * t, 0.002 * portable::sin(40.0 * t)};
    hands.water = n % 1500 < 300;
    hands.renew = n == 5000;
    hands.restore = n == 5500;
    if (n == 3000) out.position.z = 1e300;
    scene->step(hands, n % 7 == 0 ? 0.0023 : 0.001);
    if (n % 1000 == 999) hashes << std::hex << scene->state_hash() << '\n';
  }
  std::ifstream file("tests/golden/engine_trace.txt");
  ASSERT_TRUE(file) << "tests run in the project's root";
  std::ostringstream golden;
  golden << file.rdbuf();
  EXPECT_EQ(hashes.str(), golden.str());
}

}  // namespace
}  // namespace onggi
