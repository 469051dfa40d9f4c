#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/keepsake/store/visit_record.h"
#include "kiosk/keepsake/store/visit_store.h"

namespace onggi::store {

/// Runs the store on its own thread, so that no frame waits for its disk. Visits stay in memory
/// until they are on the disk: up to kMost, tried again with the next one; then the oldest is
/// dropped, and the log tells how many.
class StoreThread {
 public:
  static constexpr std::size_t kMost = 10'000;
  static constexpr std::chrono::hours kDaily{24};
  static constexpr std::chrono::seconds kGather{60};
  static constexpr std::size_t kMostNotes = 1000;  ///< Collected at once.

  /// `months` (of 30 days): how long a visit is counted and a damaged file is kept; 0: forever.
  /// Checked at the start and every `forget`. Phones' notes in `fetched` (souvenir::fetch_notes())
  /// are collected at the start, every `gather` and at the end; "": none.
  StoreThread(std::filesystem::path file, int months, std::chrono::milliseconds forget = kDaily,
              std::filesystem::path fetched = {}, std::chrono::milliseconds gather = kGather);
  /// As end().
  ~StoreThread();
  StoreThread(const StoreThread&) = delete;
  StoreThread& operator=(const StoreThread&) = delete;

  /// Main thread: adds a visit. Never waits for the disk.
  void visit(VisitRecord visit);
  /// Main thread: what staff should know, each Problem once.
  std::vector<Problem> remarks();
  /// Waits until the file was opened and every visit was tried.
  void finish();
  /// Tries the remaining visits once more and ends the thread. Visits that fail now are lost, and
  /// their number is among remarks(). Add nothing after it.
  void end();

 private:
  void run();
  bool open();
  void write(std::deque<VisitRecord>& visits);
  void drop_oldest(std::deque<VisitRecord>& visits);
  bool set_aside();
  void forget();
  void gather();
  void remark(const Problem& problem);
  void say(const Problem& problem);

  const std::filesystem::path file_;
  const int months_;
  const std::chrono::milliseconds forget_every_;
  const std::filesystem::path fetched_;
  const std::chrono::milliseconds gather_every_;
  /// This and the following members belong to the store's thread.
  std::optional<VisitStore> store_;
  /// Reported since a visit was last counted, so that each trouble is reported once.
  std::set<std::string> said_;
  std::size_t dropped_ = 0;  ///< Visits dropped since then.

  std::mutex mutex_;  ///< Guards the members below; held for a swap, never during a write.
  std::condition_variable wake_, idle_;
  std::deque<VisitRecord> visits_;
  std::vector<Problem> remarks_;
  bool working_ = true, stop_ = false;
  std::thread thread_;
};

}  // namespace onggi::store
