#include "kiosk/docs/example/pipe_hand.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>

namespace onggi::example {

namespace {

constexpr int kWaitMs = 5;
constexpr int kSilence = 4;      // Waits without a pose: then nobody is there.
constexpr double kStuck = 0.01;  // s without a tick of the loop: then it pushes no more.

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

PipeHand::PipeHand(int poses, int forces, const device::ForceLimits& limits)
    : poses_(poses), forces_(forces), limits_(limits) {
  fcntl(poses_, F_SETFL, O_NONBLOCK);
  fcntl(forces_, F_SETFL, O_NONBLOCK);  // A reader that stands still must not hold the gate up.
  thread_ = std::thread([this] { run(); });
}

PipeHand::~PipeHand() {
  stop_ = true;
  thread_.join();
  close(poses_);
  close(forces_);
}

HandInput PipeHand::read(double) noexcept {
  pose_.take(newest_);
  HandInput hand;
  hand.position = newest_.at;
  hand.active = newest_.held;
  return hand;
}

void PipeHand::feel(const HandFeedback& feedback) noexcept {
  mine_.force = feedback.force;
  mine_.ticks += 1.0;
  wish_.put(mine_);
}

// The driver's own thread: it alone talks to the device, and the gate is the last thing it does.
void PipeHand::run() {
  device::ForceGate gate;
  Wish wish;
  double renewed = now(), turned = renewed;
  char text[4096];
  std::size_t filled = 0;
  int silent = 0;
  while (!stop_) {
    pollfd wait{poses_, POLLIN, 0};
    poll(&wait, 1, kWaitMs);
    const ssize_t got = ::read(poses_, text + filled, sizeof text - 1 - filled);
    filled += got > 0 ? static_cast<std::size_t>(got) : 0;
    text[filled] = '\0';
    // The newest whole line wins.
    Pose pose;
    bool news = false, broken = false;
    char* line = text;
    for (char* end; (end = std::strchr(line, '\n')) != nullptr; line = end + 1) {
      int held = 0;
      news = std::sscanf(line, "%lf %lf %lf %d", &pose.at.x, &pose.at.y, &pose.at.z, &held) == 4;
      broken = broken || !news;
      pose.held = held != 0;
    }
    filled -= static_cast<std::size_t>(line - text);
    std::memmove(text, line, filled);
    if (filled + 1 >= sizeof text) filled = 0;  // No line is so long.
    silent = news ? 0 : silent + 1;
    if (silent >= kSilence) pose.held = false;
    if (news || silent >= kSilence) pose_.put(pose);

    const double time = now();
    if (wish_.take(wish)) renewed = time;
    device::LinkFault fault = broken                    ? device::LinkFault::bad_report
                              : silent >= kSilence      ? device::LinkFault::stall
                              : time - renewed > kStuck ? device::LinkFault::stuck_tick
                                                        : device::LinkFault::none;
    const Vec3 force = gate.step(wish.force, time - turned, limits_, fault);
    turned = time;
    if (!news && fault == device::LinkFault::none) continue;
    char answer[96];
    const int size =
        std::snprintf(answer, sizeof answer, "%.4f %.4f %.4f\n", force.x, force.y, force.z);
    if (::write(forces_, answer, static_cast<std::size_t>(size)) < 0) continue;
  }
}

}  // namespace onggi::example
