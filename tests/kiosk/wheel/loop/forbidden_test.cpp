// What the 1 kHz thread must never do, caught where the C library would do it: malloc and its kin,
// pthread_mutex_lock and write, in this whole program. A sanitizer brings its own, so there this is
// skipped by name.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdlib>

#include "kiosk/wheel/device/hid_hand.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/wheel/loop/pots.h"
#include "tests/stand_in/simulated_handle.h"
#include "tests/stand_in/world.h"
#include "tests/support/sanitized.h"

namespace {
thread_local bool on_the_tick = false;
std::atomic<long> allocated{0}, locked{0}, written{0};
}  // namespace

#if !ONGGI_SANITIZED
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void __libc_free(void* old);

void* malloc(std::size_t size) noexcept {
  if (on_the_tick) ++allocated;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  if (on_the_tick) ++allocated;
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  if (on_the_tick) ++allocated;
  return __libc_realloc(old, size);
}
void free(void* old) noexcept {
  if (on_the_tick && old != nullptr) ++allocated;
  __libc_free(old);
}
int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  static const auto real =
      reinterpret_cast<int (*)(pthread_mutex_t*)>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  if (on_the_tick) ++locked;
  return real(mutex);
}
ssize_t write(int file, const void* bytes, std::size_t size) {
  static const auto real =
      reinterpret_cast<ssize_t (*)(int, const void*, std::size_t)>(dlsym(RTLD_NEXT, "write"));
  if (on_the_tick) ++written;
  return real(file, bytes, size);
}
}
#endif

namespace onggi::loop::forbidden_test {
namespace {

/// A small pot with every effect there is.
SceneDef every_effect() {
  SceneDef def;
  def.clay.rows = 48;
  def.clay.sectors = 32;
  each_effect(def, [](auto& effect) {
    if (!effect) effect.emplace();
  });
  def.moisture->sponge_height = 0.04;
  def.walls->bending_strength = 9000.0;
  def.walls->tear_thickness = 0.006;
  def.walls->tear_strain = 2.0;
  return def;
}

TEST(Loop, InAHundredThousandTicksWithEveryEffectAndADeviceNothingIsAllocatedLockedOrWritten) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns malloc";
  // The counters count.
  on_the_tick = true;
  std::free(std::malloc(1));
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  pthread_mutex_lock(&mutex);
  pthread_mutex_unlock(&mutex);
  on_the_tick = false;
  ASSERT_GE(allocated.exchange(0), 2);
  ASSERT_GE(locked.exchange(0), 1);

  stand_in::World world;
  world.clock = stand_in::World::Clock::real;
  const SceneDef def = every_effect();
  ASSERT_TRUE(validate(def));
  std::vector<stand_in::TrackPoint> points;
  for (int ms = 0; ms < 60000; ++ms)
    points.push_back({{0.0655 - 0.004 * (1 - std::cos(ms * 0.006)), 0.10, 0.0}, true});
  world.plug(std::make_unique<stand_in::SimulatedHandle>(stand_in::Track(points)));
  auto bus = stand_in::bus_of(world);
  const auto listed = bus->list();
  device::LinkParts parts{bus->open(listed.at(0).path), device::DeviceKind::onggi_hid, listed[0],
                          device::default_def(device::DeviceKind::onggi_hid)};
  auto link = device::HidLink::begin(std::move(parts), device::HidLink::Turning::by_thread);
  ASSERT_TRUE(link);

  SteppedWheel wheel_host;
  ASSERT_NE(wheel_host.attach(std::make_unique<device::HidHand>(std::move(link)), 0), nullptr);
  wheel_host.start(pot(def));
  std::uint64_t ticks = 0, touched = 0, pressed = 0;
  bool tore = false;
  for (int frame = 0; frame < 4000; ++frame) {
    wheel_host.wheel(12.0);
    wheel_host.water(frame % 100 < 20);
    if (frame % 1000 == 999) wheel_host.restore();
    // The device keeps its own time, in which 100 s are a blink: the other hand keeps the clay's,
    // up and down the wall and deeper each time, and then there are a new lump and another tool.
    const int stroke = frame % 200;
    const std::size_t tools = def.tools.size() + 1;
    if (stroke == 1)
      wheel_host.take(1, static_cast<std::uint8_t>(static_cast<std::size_t>(frame / 200) % tools));
    if (stroke == 199) wheel_host.renew();
    HandInput other;
    other.active = stroke > 2 && stroke < 190;
    other.position = {-0.0635 + 4e-5 * stroke, 0.06 + 0.03 * std::sin(0.1 * frame), 0.0};
    wheel_host.hand(1, other);
    on_the_tick = true;
    wheel_host.advance(25);
    on_the_tick = false;
    ticks += 25;
    wheel_host.collect();
    const auto& felt = wheel_host.view().status.feedback;
    touched += felt.hand[0].contact ? 1 : 0;
    pressed += felt.hand[1].contact ? 1 : 0;
    tore = tore || felt.torn;
  }
  EXPECT_EQ(ticks, 100'000u);
  EXPECT_GT(touched, 100u) << "the device's hand worked";
  EXPECT_GT(pressed, 1000u) << "and so did the other";
  EXPECT_TRUE(tore);
  EXPECT_EQ(allocated, 0);
  EXPECT_EQ(locked, 0);
  EXPECT_EQ(written, 0);
}

}  // namespace
}  // namespace onggi::loop::forbidden_test
