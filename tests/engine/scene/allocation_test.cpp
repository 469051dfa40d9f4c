// Counts operator new in this program: the tick must not reach it. A sanitizer brings its own
// operator new, so there these tests are skipped by name.
#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "engine/scene/scene.h"
#include "tests/support/effect_scenes.h"
#include "tests/support/sanitized.h"

namespace {
std::atomic<long> allocations{0};
std::atomic<std::size_t> resident{0};  // bytes, with what the allocator rounds up
std::atomic<long> allocated_bytes{0};
}  // namespace

#if !ONGGI_SANITIZED
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  allocated_bytes += static_cast<long>(size);
  void* p = std::malloc(size);
  if (p == nullptr) throw std::bad_alloc();
  resident += malloc_usable_size(p);
  return p;
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  resident -= malloc_usable_size(p);
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { operator delete(p); }
#endif

namespace onggi::allocation_test {
namespace {

TEST(Scene, AStepAllocatesNothingWhateverHappensInIt) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns operator new";
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

SceneDef papers_scene() {
  SceneDef def;
  def.clay.height = 0.072;
  def.clay.inner_radius = def.clay.radius_min = 0.0001;
  def.clay.wall_min = 0.0005;
  def.clay.floor_thickness = 0.0;
  def.clay.keep_undo = false;
  def.friction.reset();
  def.moisture.reset();
  def.paper.emplace();
  return def;
}

TEST(Scene, ThePapersSceneKeepsAtMostTwelveBytesForEachElement) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns operator new";
  const std::size_t before = resident;
  auto scene = Scene::create(papers_scene());
  ASSERT_TRUE(scene);
  const double each = static_cast<double>(resident - before) / (400.0 * 360.0);
  EXPECT_GE(each, 8.0);  // it does hold a grid
  EXPECT_LE(each, 12.0);
}

TEST(Scene, AStepOfThePapersSceneAllocatesNothing) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns operator new";
  auto scene = Scene::create(papers_scene());
  ASSERT_TRUE(scene);
  Hands hands;
  hands.wheel_speed = 20.0;
  hands.hand[0].active = true;
  const long before = allocations;
  for (int n = 0; n < 500; ++n) {
    hands.hand[0].position = {0.065 - n * 2e-5, 0.036, 0.001 * (n % 7)};
    scene->step(hands, 0.001);
  }
  EXPECT_EQ(allocations, before);
}

TEST(Scene, AnEffectThatIsAbsentAllocatesNotAByteAndOneThatIsPresentAFewARow) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns operator new";
  const auto bytes_of = [](const SceneDef& def) {
    const long before = allocated_bytes;
    EXPECT_TRUE(Scene::create(def));
    return allocated_bytes - before;
  };
  const auto grid_of = [](const ClayDef& def) {
    const long before = allocated_bytes;
    EXPECT_TRUE(Clay::create(def));
    return allocated_bytes - before;
  };
  SceneDef small;
  small.clay.keep_undo = false;
  const long base = bytes_of(bare(small));
  EXPECT_LT(base - grid_of({}), 16384);  // the clay, the scene's own figures, the tools, the slit
  for (const EffectTrial& effect : effect_trials()) {
    SceneDef def = bare(small);
    effect.leave_out_full_of_nan(def);
    EXPECT_EQ(bytes_of(def), base) << effect.name;
    effect.add(def);
    const long elements = def.clay.rows * def.clay.sectors;
    const bool by_elements = def.propagation || def.springback || def.smoothing;
    // A pot that is built has rows for its tallest height, and what its rings need to be taken
    // back.
    const double rows = def.building ? 1.0 + def.building->tallest / def.clay.height : 0.0;
    const long coils = static_cast<long>(24.0 * rows * static_cast<double>(elements));
    const long each = (by_elements ? 17 : 0) + (def.volume ? 9 : 0);  // as many rows again to spare
    const long marks = def.prints ? 312'000 : 0;                      // as many on every grid
    EXPECT_LT(bytes_of(def) - base, each * elements + coils + marks + 200 * def.clay.rows)
        << effect.name;
  }
}

TEST(Scene, AStepWithEveryEffectAllocatesNothing) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns operator new";
  SceneDef def;
  for (const EffectTrial& effect : effect_trials()) effect.add(def);
  def.moisture->sponge_height = 0.05;
  def.clay.inner_radius = 0.036;
  def.walls->tear_thickness = 0.02;  // where it is touched
  auto scene = Scene::create(def);
  ASSERT_TRUE(scene);
  Hands hands;
  hands.wheel_speed = 20.0;
  hands.hand[0].active = hands.hand[1].active = true;
  const long before = allocations;
  bool torn = false;
  for (int n = 0; n < 2000; ++n) {
    hands.hand[0].position = {0.07 - n * 1e-5, 0.1, 0.001 * (n % 7)};
    hands.hand[1].position = {0.03, 0.25 - n * 1e-4, 0};
    hands.water = n % 3 == 0;
    hands.renew = n % 900 == 600;
    hands.restore = n % 900 == 800;
    torn = scene->step(hands, 0.001).torn || torn;
  }
  EXPECT_EQ(allocations, before);
  EXPECT_TRUE(torn);
}

TEST(Scene, ADefThatIsRefusedAllocatesNoGrid) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns operator new";
  SceneDef def;
  def.clay.rows = 20000;
  def.clay.sectors = 1024;  // 160 MB, were it made
  def.guard.max_force = 100.0;
  SceneDef vast;
  vast.clay.rows = vast.clay.sectors = 1'000'000;  // 8 TB, were it made
  for (const SceneDef& refused : {def, vast}) {
    const long before = allocations;
    const long bytes_before = allocated_bytes;
    EXPECT_FALSE(Scene::create(refused));
    EXPECT_LT(allocations - before, 50);  // the words of the Problem
    EXPECT_LT(allocated_bytes - bytes_before, 10000);
  }
}

}  // namespace
}  // namespace onggi::allocation_test
