// Counts operator new in this program: neither the tick nor what the main thread does for every row
// may reach it. A sanitizer brings its own, so there this is skipped by name.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>

#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/support/sanitized.h"

namespace {
std::atomic<long> allocations{0};
}

#if !ONGGI_SANITIZED
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  void* p = std::malloc(size);
  if (p == nullptr) throw std::bad_alloc();
  return p;
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
#endif

namespace onggi::loop::allocation_test {
namespace {

TEST(Potter, NeitherATickNorACollectedRowAllocates) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns operator new";
  SceneDef def;
  def.clay.rows = 80;
  def.clay.sectors = 64;
  def.volume.emplace();
  def.moisture->sponge_height = 0.04;
  SteppedWheel wheel_host;
  wheel_host.start(std::make_unique<Scene>(std::move(*Scene::create(def))));
  HandInput hand;
  hand.active = true;
  int rows = 0;
  long before = 0;
  for (int frame = 0; frame < 200; ++frame) {
    if (frame == 20) before = allocations;
    wheel_host.wheel(15);
    hand.position = {0.063 - 2e-5 * frame, 0.1, 0};
    wheel_host.hand(0, hand);
    wheel_host.take(0, static_cast<std::uint8_t>(frame / 40));
    wheel_host.clear_faults(~0u);
    wheel_host.water(frame % 2 == 0);
    wheel_host.advance(33);
    rows += wheel_host.collect();
  }
  EXPECT_EQ(allocations, before);
  EXPECT_GT(rows, 1000);
}

}  // namespace
}  // namespace onggi::loop::allocation_test
