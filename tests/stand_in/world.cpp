#include "tests/stand_in/world.h"

#include <time.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace onggi::stand_in {

namespace {

constexpr std::size_t kQueue = 64;  // What hidraw keeps.

std::int64_t monotonic_ns() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

}  // namespace

const PlannedFault* Socket::under(Fault fault) const {
  for (const PlannedFault& f : faults)
    if (f.fault == fault && ms >= f.at && ms < f.at + f.lasts) return &f;
  return nullptr;
}

World::~World() {
  if (file_ != nullptr) std::fclose(file_);
}

Socket& World::plug(std::unique_ptr<SimulatedDevice> device, std::vector<PlannedFault> faults) {
  auto socket = std::make_unique<Socket>();
  socket->path = "stand-in/hidraw" + std::to_string(sockets_.size());
  socket->device = std::move(device);
  socket->faults = std::move(faults);
  socket->plugs = 1;
  sockets_.push_back(std::move(socket));
  return *sockets_.back();
}

void World::note(const Socket& socket, bool out, const Bytes& bytes) {
  if (keeps) record.push_back({socket.ms, out, bytes});
  if (record_file.empty()) return;
  if (file_ == nullptr) file_ = std::fopen(record_file.c_str(), "w");
  if (file_ == nullptr) return;
  std::fprintf(file_, "%s %ld %s", socket.path.c_str(), socket.ms, out ? "out" : "in");
  for (const std::uint8_t byte : bytes) std::fprintf(file_, " %02x", byte);
  std::fputc('\n', file_);
  std::fflush(file_);
}

void World::pass(Socket& socket, long ms) {
  for (long n = 0; n < ms; ++n) {
    ++socket.ms;
    const bool there = socket.ms >= socket.plugged_at && socket.under(Fault::unplug) == nullptr;
    if (there != std::exchange(socket.present, there)) {
      socket.device->plug(there);
      socket.waiting.clear();
      if (there) ++socket.plugs;
    }
    auto report = socket.device->tick();
    if (!there || !report || socket.under(Fault::stall) != nullptr) continue;
    if (socket.under(Fault::replay) != nullptr && !socket.before.empty()) report = socket.before;
    socket.before = *report;
    if (socket.under(Fault::flip) != nullptr)
      (*report)[1 + static_cast<std::size_t>(socket.ms) % (report->size() - 1)] ^= 0x10;
    if (socket.under(Fault::shorten) != nullptr) report->pop_back();
    if (socket.under(Fault::reorder) != nullptr) {
      if (socket.kept.empty()) {
        socket.kept = *report;
        continue;
      }
      socket.waiting.push_back(*report);
      report = std::exchange(socket.kept, {});
    }
    socket.waiting.push_back(*report);
    if (socket.waiting.size() > kQueue) socket.waiting.erase(socket.waiting.begin());
  }
}

/// Real time: every device is brought up to now.
void World::catch_up() {
  const std::int64_t now = monotonic_ns();
  if (began_ns_ < 0) began_ns_ = now;
  for (const auto& socket : sockets_)
    pass(*socket, std::max<long>(0, (now - began_ns_) / 1'000'000 - socket->ms));
}

std::vector<device::HidListing> World::list() {
  const std::lock_guard lock(mutex_);
  if (clock == Clock::real) catch_up();
  std::vector<device::HidListing> all;
  for (const auto& socket : sockets_) {
    // By reads nobody turns a device that is not open: looking for it does.
    const bool read_by_someone =
        std::any_of(handles_.begin(), handles_.end(), [&](const Handle& h) {
          return h.open && h.socket == socket.get() && h.plug == socket->plugs && socket->present;
        });
    if (clock == Clock::reads && !read_by_someone && !socket->present) pass(*socket, away_ms);
    if (!socket->present || socket->ms < socket->plugged_at) continue;
    all.push_back(socket->device->listing());
    all.back().path = socket->path;
  }
  return all;
}

int World::open(const std::string& path) {
  const std::lock_guard lock(mutex_);
  for (const auto& socket : sockets_) {
    if (socket->path != path || !socket->present) continue;
    socket->waiting.clear();
    handles_.push_back({socket.get(), socket->plugs, true});
    return static_cast<int>(handles_.size()) - 1;
  }
  return -1;
}

Socket* World::socket_of(int handle) {
  if (handle < 0 || handle >= static_cast<int>(handles_.size())) return nullptr;
  const Handle& h = handles_[static_cast<std::size_t>(handle)];
  return h.open && h.socket->present && h.plug == h.socket->plugs ? h.socket : nullptr;
}

int World::read(int handle, std::uint8_t* into, std::size_t size, int timeout_ms) {
  const std::int64_t until = monotonic_ns() + std::max(0, timeout_ms) * std::int64_t{1'000'000};
  for (;;) {
    {
      const std::lock_guard lock(mutex_);
      if (clock == Clock::real) catch_up();
      Socket* const socket = socket_of(handle);
      if (socket == nullptr) return -1;
      if (!socket->waiting.empty()) {
        const Bytes report = socket->waiting.front();
        socket->waiting.erase(socket->waiting.begin());
        note(*socket, false, report);
        const std::size_t length = std::min(size, report.size());
        std::memcpy(into, report.data(), length);
        return static_cast<int>(length);
      }
      if (clock == Clock::reads) {
        pass(*socket, 1);
        return socket->present ? 0 : -1;
      }
    }
    if (monotonic_ns() >= until) return 0;
    const timespec pause{0, 200'000};
    nanosleep(&pause, nullptr);
  }
}

bool World::write(int handle, const std::uint8_t* bytes, std::size_t size) {
  const std::lock_guard lock(mutex_);
  if (clock == Clock::real) catch_up();
  Socket* const socket = socket_of(handle);
  if (socket == nullptr) return false;
  const Bytes report(bytes, bytes + size);
  note(*socket, true, report);
  return socket->under(Fault::deafen) != nullptr || socket->device->take(report);
}

int World::feature(int handle, std::uint8_t* into, std::size_t size) {
  const std::lock_guard lock(mutex_);
  Socket* const socket = socket_of(handle);
  if (socket == nullptr || size == 0) return -1;
  const auto said = socket->device->feature(into[0]);
  if (!said) return -1;
  const std::size_t length = std::min(size, said->size());
  std::memcpy(into, said->data(), length);
  return static_cast<int>(length);
}

void World::close(int handle) {
  const std::lock_guard lock(mutex_);
  if (handle >= 0 && handle < static_cast<int>(handles_.size()))
    handles_[static_cast<std::size_t>(handle)].open = false;
}

namespace {

class WorldPort final : public device::HidPort {
 public:
  WorldPort(World& world, int handle) : world_(world), handle_(handle) {}
  ~WorldPort() override { world_.close(handle_); }
  int read(std::span<std::uint8_t> into, int timeout_ms) noexcept override {
    return world_.read(handle_, into.data(), into.size(), timeout_ms);
  }
  bool write(device::Report report) noexcept override {
    return world_.write(handle_, report.data(), report.size());
  }
  int feature(std::uint8_t id, std::span<std::uint8_t> into) noexcept override {
    into[0] = id;
    return world_.feature(handle_, into.data(), into.size());
  }

 private:
  World& world_;
  int handle_;
};

class WorldBus final : public device::HidBus {
 public:
  explicit WorldBus(World& world) : world_(world) {}
  std::vector<device::HidListing> list() override { return world_.list(); }
  std::unique_ptr<device::HidPort> open(const std::string& path) override {
    const int handle = world_.open(path);
    return handle < 0 ? nullptr : std::make_unique<WorldPort>(world_, handle);
  }

 private:
  World& world_;
};

}  // namespace

std::unique_ptr<device::HidBus> bus_of(World& world) { return std::make_unique<WorldBus>(world); }

}  // namespace onggi::stand_in
