#include "tests/support/engine_trace.h"

#include <algorithm>
#include <sstream>

#include "engine/math/portable.h"
#include "engine/scene/scene.h"

namespace onggi {

std::string engine_trace(int seconds, Vectors kind) {
  auto scene = Scene::create({}, kind);
  if (!scene) return "";
  std::ostringstream hashes;
  Hands hands;
  hands.wheel_speed = 21.0;
  for (int n = 0; n < 1000 * seconds; ++n) {
    const double t = n * 0.001;
    HandInput& out = hands.hand[0];
    HandInput& in = hands.hand[1];
    out.active = n % 2500 > 100;
    out.position = {0.064 - 0.006 * portable::sin(2.0 * t), 0.02 + 0.03 * t,
                    0.01 * portable::cos(3.0 * t)};
    in.active = n > 2200 && n < 4800;
    in.side = SideWish::inside;
    in.position = {-0.012 - 0.004 * (t - 2.0), 0.15 - 0.02 * t, 0.002 * portable::sin(40.0 * t)};
    // On the rim, and down through the floor.
    if (n >= 3600 && n < 4500) out.position = {0.050, 0.2075 - 0.001 * (t - 3.6), 0.01};
    if (n >= 3400) in.position.y = std::max(in.position.y - 0.08 * (t - 3.4), 0.011);
    hands.water = n % 1500 < 300;
    hands.renew = n == 5000;
    hands.restore = n == 5500;
    if (n == 3000) out.position.z = 1e300;
    scene->step(hands, n % 7 == 0 ? 0.0023 : 0.001);
    if (n % 1000 == 999) hashes << std::hex << scene->state_hash() << '\n';
  }
  return hashes.str();
}

}  // namespace onggi
