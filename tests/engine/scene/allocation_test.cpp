// Counts operator new in this program: the tick must not reach it.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "engine/scene/scene.h"

namespace {
std::atomic<long> allocations{0};
}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace onggi {
namespace {

TEST(Scene, AStepAllocatesNothingWhateverHappensInIt) {
  auto scene = Scene::create({});
  ASSERT_TRUE(scene);
  Hands hands;
  hands.wheel_speed = 20.0;
  hands.hand[0].active = true;
  hands.hand[1].active = true;
  const long before = allocations;
  for (int n = 0; n < 2000; ++n) {
    hands.hand[0].position = {0.07 - n * 2e-5, 0.1, 0.001 * (n % 7)};
    hands.hand[1].position = {n % 500 == 0 ? 1e300 : 0.01, 0.12, 0};
    hands.water = n % 3 == 0;
    hands.renew = n % 400 == 300;
    hands.restore = n % 400 == 399;
    scene->step(hands, n % 100 == 0 ? -1.0 : 0.001);
    scene->take_dirty_row(0);
  }
  EXPECT_EQ(allocations, before);
}

TEST(Scene, ADefThatIsRefusedAllocatesNoGrid) {
  SceneDef def;
  def.clay.rows = 20000;
  def.clay.sectors = 1024;  // 160 MB, were it made
  def.guard.max_force = 100.0;
  const long before = allocations;
  EXPECT_FALSE(Scene::create(def));
  EXPECT_LT(allocations - before, 50);  // the words of the Problem
}

}  // namespace
}  // namespace onggi
