#include "kiosk/store/store_thread.h"

#include <chrono>
#include <ctime>
#include <limits>
#include <utility>

namespace onggi::store {

namespace {

std::string local_time(std::time_t at, const char* format) {
  std::tm local{};
  localtime_r(&at, &local);
  char text[64];
  return {text, std::strftime(text, sizeof text, format, &local)};
}

std::int64_t bytes_in(const std::filesystem::path& folder) {
  std::int64_t bytes = 0;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    std::error_code ignored;
    const auto size = at->file_size(ignored);
    if (!ignored) bytes += static_cast<std::int64_t>(size);
  }
  return bytes;
}

}  // namespace

StoreThread::StoreThread(std::filesystem::path file, int months)
    : file_(std::move(file)), months_(months), thread_([this] { run(); }) {}

StoreThread::~StoreThread() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void StoreThread::hand_over(Job job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  wake_.notify_one();
}

std::vector<Problem> StoreThread::remarks() {
  const std::lock_guard lock(mutex_);
  return std::exchange(remarks_, {});
}

void StoreThread::finish() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [this] { return jobs_.empty() && !working_; });
}

void StoreThread::run() {
  std::deque<Job> mine;
  if (open()) sweep();
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      working_ = false;
      idle_.notify_all();
      const bool woken = wake_.wait_for(lock, std::chrono::seconds(kSweep),
                                        [this] { return !jobs_.empty() || stop_; });
      if (jobs_.empty() && woken) return;
      working_ = true;
      for (Job& job : jobs_) mine.push_back(std::move(job));
      jobs_.clear();
    }
    write(mine);
    sweep();
    if (mine.size() <= kMost) continue;
    const std::size_t over = mine.size() - kMost;
    mine.erase(mine.begin(), mine.begin() + static_cast<std::ptrdiff_t>(over));
    say({file_.string(), std::to_string(over) + " could not be counted and are forgotten.",
         "Make room on the disk and the folder writable. Play goes on.", 1});
  }
}

void StoreThread::say(const Problem& problem) {
  if (std::exchange(last_said_, problem.what) == problem.what) return;
  const std::lock_guard lock(mutex_);
  remarks_.push_back(problem);
}

bool StoreThread::open() {
  if (store_) return true;
  std::vector<Problem> remarks;
  const std::time_t now = std::time(nullptr);
  auto opened = VisitStore::open(file_, local_time(now, "%Y-%m-%d_%H%M%S"), remarks);
  for (const Problem& remark : remarks) say(remark);
  if (!opened) {
    say(opened.error());
    return false;
  }
  store_.emplace(std::move(*opened));
  if (months_ > 0) {
    const std::time_t oldest = now - static_cast<std::time_t>(months_) * 30 * 24 * 3600;
    if (auto good = store_->forget_before(local_time(oldest, "%Y-%m-%d")); !good) say(good.error());
  }
  return true;
}

/// What has expired is removed, and what somebody else removed is not noted any longer.
void StoreThread::sweep() {
  if (!store_) return;
  const std::filesystem::path folder = file_.parent_path();
  constexpr auto kNever = std::numeric_limits<std::int64_t>::max();
  const auto now = static_cast<std::int64_t>(std::time(nullptr));
  const auto all = store_->due(kNever, 0);
  if (!all) return say(all.error());
  for (const KeepsakeRecord& k : *all) {
    std::error_code error;
    const bool expired = k.expires_at != 0 && k.expires_at <= now;
    // A name is one folder's, and never leads out of this one.
    if (k.name.empty() || k.name[0] == '.' || k.name.find('/') != std::string::npos) continue;
    if (expired) std::filesystem::remove_all(folder / k.name, error);
    if (error)
      say({(folder / k.name).string(), "A keepsake that has expired could not be removed.",
           "Make the folder writable.", 1});
    else if (!std::filesystem::exists(folder / k.name, error) && !error)
      store_->dropped(k.name);
  }
}

/// What could be written is taken out of `jobs`. A file that turns out damaged is left for the one
/// that open() begins in its place.
void StoreThread::write(std::deque<Job>& jobs) {
  for (int attempt = 0; attempt < 2 && !jobs.empty(); ++attempt) {
    if (!open()) return;
    std::vector<VisitRecord> visits;
    for (const Job& job : jobs)
      if (const auto* visit = std::get_if<VisitRecord>(&job)) visits.push_back(*visit);
    Result<void> good;
    if (!visits.empty()) good = store_->add(visits);
    if (good)
      std::erase_if(jobs, [](const Job& job) { return std::holds_alternative<VisitRecord>(job); });
    while (good && !jobs.empty()) {
      auto& keepsake = std::get<KeepsakeRecord>(jobs.front());
      if (keepsake.bytes == 0) keepsake.bytes = bytes_in(file_.parent_path() / keepsake.name);
      good = store_->keep(keepsake);
      if (good) jobs.pop_front();
    }
    if (good) {
      last_said_.clear();
      return;
    }
    const bool damaged = store_->trouble() == Trouble::damaged;
    say(good.error());
    if (!damaged) return;
    store_.reset();
  }
}

}  // namespace onggi::store
