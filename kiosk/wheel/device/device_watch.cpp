#include "kiosk/wheel/device/device_watch.h"

#include <chrono>
#include <utility>

#include "kiosk/wheel/device/device_access.h"

namespace onggi::device {

namespace {
constexpr std::chrono::milliseconds kBetweenLooks{1000};
}

DeviceWatch::DeviceWatch(std::unique_ptr<HidBus> bus, HidLink::Turning turning, Define define)
    : bus_(std::move(bus)), turning_(turning), define_(std::move(define)) {
  if (turning_ == HidLink::Turning::by_thread) thread_ = std::thread([this] { run(); });
}

DeviceWatch::~DeviceWatch() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  stop_soon_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void DeviceWatch::run() {
  for (;;) {
    look();
    std::unique_lock lock(mutex_);
    if (stop_soon_.wait_for(lock, kBetweenLooks, [this] { return stop_; })) return;
  }
}

void DeviceWatch::look() {
  std::set<std::string> here;
  for (const HidListing& listing : bus_->list()) {
    const auto kind = kind_of(listing);
    if (!kind) continue;
    here.insert(listing.path);
    {
      const std::lock_guard lock(mutex_);
      if (open_.contains(listing.path)) continue;
    }
    open(listing, *kind);
  }
  // An unplugged device may be reported again when it returns.
  std::erase_if(reported_, [&here](const std::string& path) { return !here.contains(path); });
}

void DeviceWatch::open(const HidListing& listing, DeviceKind kind) {
  std::optional<Problem> problem = access_problem(listing);
  std::unique_ptr<HidLink> link;
  if (!problem) {
    LinkParts parts{bus_->open(listing.path), kind, listing, define_(kind)};
    const bool opened = parts.port != nullptr;
    if (opened) link = HidLink::begin(std::move(parts), turning_);
    if (!link)
      problem = Problem{listing.path,
                        std::string(info_of(kind).name) +
                            (opened ? " does not answer as expected." : " could not be opened."),
                        "Unplug it and plug it in again. If it is another device with the same "
                        "numbers, nothing needs to be done.",
                        1};
  }
  const bool told = problem && !reported_.insert(listing.path).second;
  const std::lock_guard lock(mutex_);
  if (link) {
    open_.insert(listing.path);
    arrived_.push_back(std::move(link));
  } else if (!told) {
    problems_.push_back(*problem);
  }
}

std::vector<std::unique_ptr<HidLink>> DeviceWatch::arrived() {
  const std::lock_guard lock(mutex_);
  return std::exchange(arrived_, {});
}

void DeviceWatch::gone(const std::string& path) {
  const std::lock_guard lock(mutex_);
  open_.erase(path);
}

std::vector<Problem> DeviceWatch::problems() {
  const std::lock_guard lock(mutex_);
  return std::exchange(problems_, {});
}

}  // namespace onggi::device
