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

/// The store on a thread of its own, so that no frame waits for its disk. What is handed over is
/// kept in memory until it is on the disk: up to kMost, tried again with what comes next; then the
/// oldest is dropped, and the log says how many.
class StoreThread {
 public:
  static constexpr std::size_t kMost = 10'000;
  static constexpr std::chrono::hours kDaily{24};
  static constexpr std::chrono::seconds kGather{60};
  static constexpr std::size_t kMostNotes = 1000;  ///< Taken up at once.

  /// `months` (of 30 days) that a visit is counted, and that a damaged file lies aside, before it
  /// is forgotten; 0: for ever. That is seen to at the start and every `forget`.
  /// What phones fetched is taken up from the notes in `fetched` (files::fetch_notes()) at the
  /// start, every `gather` and at the end; "": from nowhere.
  StoreThread(std::filesystem::path file, int months, std::chrono::milliseconds forget = kDaily,
              std::filesystem::path fetched = {}, std::chrono::milliseconds gather = kGather);
  /// As end().
  ~StoreThread();
  StoreThread(const StoreThread&) = delete;
  StoreThread& operator=(const StoreThread&) = delete;

  /// Main's: never waits for the disk.
  void visit(VisitRecord visit);
  /// Main's: what staff should know, a Problem once.
  std::vector<Problem> remarks();
  /// Waits until the file was opened and all that was handed over has been tried.
  void finish();
  /// Tries once more what the disk has not taken, and ends the thread: what it does not take now is
  /// lost, and how many they are is among remarks(). Nothing is handed over after it.
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
  std::optional<VisitStore> store_;  ///< Its thread's, as what follows.
  std::set<std::string> said_;       ///< Since a visit was last counted: a trouble is said once.
  std::size_t dropped_ = 0;          ///< Visits since then.

  std::mutex mutex_;  ///< Of what follows; held for a swap, never over a write.
  std::condition_variable wake_, idle_;
  std::deque<VisitRecord> visits_;
  std::vector<Problem> remarks_;
  bool working_ = true, stop_ = false;
  std::thread thread_;
};

}  // namespace onggi::store
