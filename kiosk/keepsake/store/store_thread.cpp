#include "kiosk/keepsake/store/store_thread.h"

#include <algorithm>
#include <ctime>
#include <utility>

#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/wall_clock.h"

namespace onggi::store {

namespace {
std::string stamp() { return files::local_time(files::wall_now(), files::kStamp); }
}  // namespace

StoreThread::StoreThread(std::filesystem::path file, int months, std::chrono::milliseconds forget,
                         std::filesystem::path fetched, std::chrono::milliseconds gather)
    : file_(std::move(file)),
      months_(months),
      forget_every_(forget),
      fetched_(std::move(fetched)),
      gather_every_(fetched_.empty() ? kDaily : gather),
      thread_([this] { run(); }) {}

StoreThread::~StoreThread() { end(); }

void StoreThread::end() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void StoreThread::visit(VisitRecord visit) {
  {
    const std::lock_guard lock(mutex_);
    visits_.push_back(std::move(visit));
  }
  wake_.notify_one();
}

std::vector<Problem> StoreThread::remarks() {
  const std::lock_guard lock(mutex_);
  return std::exchange(remarks_, {});
}

void StoreThread::finish() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [this] { return visits_.empty() && !working_; });
}

void StoreThread::run() {
  using Clock = std::chrono::steady_clock;
  std::deque<VisitRecord> mine;
  forget();
  gather();
  Clock::time_point forgotten = Clock::now(), gathered = forgotten;
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      working_ = false;
      idle_.notify_all();
      wake_.wait_until(lock, std::min(forgotten + forget_every_, gathered + gather_every_),
                       [this] { return !visits_.empty() || stop_; });
      if (visits_.empty() && stop_) break;
      working_ = true;
      for (VisitRecord& visit : visits_) mine.push_back(std::move(visit));
      visits_.clear();
    }
    write(mine);
    drop_oldest(mine);
    if (Clock::now() - gathered >= gather_every_) {
      gather();
      gathered = Clock::now();
    }
    if (Clock::now() - forgotten < forget_every_) continue;
    forget();
    forgotten = Clock::now();
  }
  write(mine);
  gather();
  if (const std::size_t lost = mine.size() + dropped_; lost > 0)
    remark({file_.string(),
            std::to_string(lost) + (lost == 1 ? " visit" : " visits") +
                " could not be saved to the disk before the end, so they are not counted.",
            "Make room on the disk and the folder writable.", 1});
}

void StoreThread::remark(const Problem& problem) {
  const std::lock_guard lock(mutex_);
  remarks_.push_back(problem);
}

void StoreThread::say(const Problem& problem) {
  if (said_.insert(problem.what).second) remark(problem);
}

bool StoreThread::open() {
  if (store_ && store_->taken_away()) {
    store_.reset();
    remark({file_.string(), "It was removed while onggi ran, so counting starts again.",
            "Stop onggi before you move or empty the keepsake folder.", 1});
  }
  if (store_) return true;
  std::vector<Problem> remarks;
  auto opened = VisitStore::open(file_, stamp(), remarks);
  for (const Problem& one : remarks) remark(one);
  if (!opened) {
    say(opened.error());
    return false;
  }
  store_.emplace(std::move(*opened));
  return true;
}

/// Sets the damaged file aside. open() could not do this, because its check may miss the damage
/// that an access met. False: the file stays, which is reported.
bool StoreThread::set_aside() {
  store_.reset();
  const auto aside = VisitStore::set_aside(file_, stamp());
  if (!aside) {
    say(aside.error());
    return false;
  }
  remark(*aside);
  return true;
}

void StoreThread::forget() {
  const bool opened = open();
  if (months_ <= 0) return;
  const std::time_t now = files::wall_now();
  const std::time_t oldest = now - static_cast<std::time_t>(months_) * 30 * 24 * 3600;
  const std::string day = files::local_time(oldest, files::kDay);
  // A clock that is ten years ahead for an hour must not delete three years of visits.
  const Result<bool> leapt = opened ? store_->clock_jumped(now) : Result<bool>(false);
  if (leapt && *leapt) return;
  if (opened)
    if (auto good = store_->forget_before(day); !good) {
      if (store_->trouble() != Trouble::damaged)
        say(good.error());
      else if (set_aside())
        open();
    }
  if (auto good = VisitStore::forget_aside(file_, day); !good) say(good.error());
}

/// Notes stay until they are in the store, so what the disk refuses now is tried again.
void StoreThread::gather() {
  if (fetched_.empty()) return;
  const std::vector<souvenir::FetchNote> notes = souvenir::fetch_notes(fetched_, kMostNotes);
  if (notes.empty() || !open()) return;
  if (auto good = store_->add_fetches(notes); !good) {
    // Damage found here sets the file aside, as for a visit.
    if (store_->trouble() == Trouble::damaged)
      set_aside();
    else
      say(good.error());
    return;
  }
  for (const souvenir::FetchNote& note : notes) souvenir::remove_fetch_note(fetched_, note);
}

/// Removes the written ones from `visits`. If the file turns out to be damaged, it is set aside,
/// and they go into the new one.
void StoreThread::write(std::deque<VisitRecord>& visits) {
  for (int attempt = 0; attempt < 2 && !visits.empty(); ++attempt) {
    if (!open()) return;
    const auto good = store_->add(std::vector<VisitRecord>(visits.begin(), visits.end()));
    if (good) {
      visits.clear();
      said_.clear();
      if (const std::size_t lost = std::exchange(dropped_, 0); lost > 0)
        remark({file_.string(),
                "Visits are counted again; " + std::to_string(lost) +
                    " that could not be saved are lost.",
                "Nothing needs doing.", 1});
      return;
    }
    if (store_->trouble() != Trouble::damaged) return say(good.error());
    if (!set_aside()) return;
  }
}

void StoreThread::drop_oldest(std::deque<VisitRecord>& visits) {
  if (visits.size() <= kMost) return;
  const std::size_t over = visits.size() - kMost;
  visits.erase(visits.begin(), visits.begin() + static_cast<std::ptrdiff_t>(over));
  dropped_ += over;
  say({file_.string(),
       "More than " + std::to_string(kMost) + " visits wait for the disk; the oldest are dropped.",
       "Make room on the disk and the folder writable. Play goes on.", 1});
}

}  // namespace onggi::store
