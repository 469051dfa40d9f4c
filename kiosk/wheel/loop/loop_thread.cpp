#include "kiosk/wheel/loop/loop_thread.h"

#include <pthread.h>
#include <sched.h>
#include <time.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include <cerrno>
#include <chrono>
#include <cstring>

#include "kiosk/ground/files/memory.h"
#include "kiosk/ground/files/monotonic.h"

namespace onggi::loop {

namespace {

constexpr int kPriority = 75;  // above everything of the desktop, below the kernel's own threads

void sleep_until(std::int64_t ns) noexcept {
  const timespec t{static_cast<time_t>(ns / 1'000'000'000), static_cast<long>(ns % 1'000'000'000)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
  }
}

void flush_denormals() noexcept {
#if defined(__SSE2__)
  // FTZ and DAZ. The engine sets tiny presses to zero itself, so results do not depend on this; it
  // only prevents a stray denormal from costing a hundred cycles.
  _mm_setcsr(_mm_getcsr() | 0x8040u);
#endif
}

}  // namespace

LoopThread::LoopThread() : thread_([this] { run(); }) {}

LoopThread::~LoopThread() {
  stop_.store(true, std::memory_order_relaxed);
  thread_.join();
}

std::vector<std::string> LoopThread::remarks() const {
  int error = -1;
  for (int i = 0; i < 200 && (error = priority_error_.load()) < 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::vector<std::string> lines;
  if (error != 0)
    lines.push_back(
        "The 1 kHz loop runs at ordinary priority (" +
        std::string(error < 0 ? "no answer" : std::strerror(error)) +
        "): give the service LimitRTPRIO=80, or the user rtprio 80 in /etc/security/limits.conf.");
  if (const int lock = lock_error_.load(); lock != 0)
    lines.push_back("Its memory may be swapped out (" + std::string(std::strerror(lock)) +
                    "): give the service LimitMEMLOCK=infinity, or the user memlock unlimited in "
                    "/etc/security/limits.conf.");
  return lines;
}

LoopTiming LoopThread::timing() const {
  return {wake_us_.look(), compute_us_.look(), device_us_.look()};
}

void LoopThread::run() {
  pthread_setname_np(pthread_self(), "onggi-wheel");  // for top -H, and for a test
  flush_denormals();
  lock_error_.store(files::lock_memory());
  sched_param parameter{};
  parameter.sched_priority = kPriority;
  priority_error_.store(pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter));

  Pacer pacer;
  pacer.begin(files::monotonic_ns());
  while (!stop_.load(std::memory_order_relaxed)) {
    sleep_until(pacer.wake_at());
    const double dt = pacer.wake(files::monotonic_ns());
    core_.strained(pacer.strained());
    core_.tick(dt);
    pacer.done(files::monotonic_ns());
    wake_us_.add(pacer.wake_us());
    compute_us_.add(pacer.tick_us());
    if (const double age = core_.device_age(); age >= 0.0) device_us_.add(age * 1e6);
    LoopStatus status = core_.status();
    status.at_ns = files::monotonic_ns();
    status.deadlines = pacer.deadlines();
    block_.write(status);
  }
}

}  // namespace onggi::loop
