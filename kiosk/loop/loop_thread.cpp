#include "kiosk/loop/loop_thread.h"

#include <pthread.h>
#include <sched.h>
#include <time.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include <chrono>
#include <cstring>

namespace onggi::loop {

namespace {

constexpr int kPriority = 75;  // Above everything of the desktop, below the kernel's own threads.

std::int64_t now_ns() noexcept {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

void sleep_until(std::int64_t ns) noexcept {
  const timespec t{static_cast<time_t>(ns / 1'000'000'000), static_cast<long>(ns % 1'000'000'000)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
  }
}

void flush_denormals() noexcept {
#if defined(__SSE2__)
  // FTZ and DAZ. The engine snaps tiny presses to zero itself, so results do not depend on this; it
  // only keeps a stray denormal from costing a hundred cycles.
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
  if (error == 0) return {};
  return {
      "The 1 kHz loop runs at ordinary priority (" +
      std::string(error < 0 ? "no answer" : std::strerror(error)) +
      "): give the service LimitRTPRIO=80, or the user rtprio 80 in /etc/security/limits.conf."};
}

void LoopThread::run() {
  flush_denormals();
  sched_param parameter{};
  parameter.sched_priority = kPriority;
  priority_error_.store(pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter));

  Pacer pacer;
  pacer.begin(now_ns());
  while (!stop_.load(std::memory_order_relaxed)) {
    sleep_until(pacer.wake_at());
    const double dt = pacer.wake(now_ns());
    core_.tick(dt);
    pacer.done(now_ns());
    LoopStatus status = core_.status();
    status.deadlines = pacer.deadlines();
    block_.write(status);
  }
}

}  // namespace onggi::loop
