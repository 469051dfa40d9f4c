#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/store/visit_record.h"
#include "kiosk/store/visit_store.h"

namespace onggi::store {

/// The store on a thread of its own, so that no frame waits for its disk. What is handed over is
/// kept in memory until it is on the disk: up to kMost, tried again with what comes next; then the
/// oldest is dropped, and the log says how many.
class StoreThread {
 public:
  static constexpr std::size_t kMost = 10'000;
  static constexpr int kSweep = 600;  ///< s

  /// `months` (of 30 days) that a visit is counted before it is forgotten; 0: for ever. Keepsakes
  /// lie beside `file`: those that have expired are removed from there, at the start, at each new
  /// one and every kSweep; no other folder ever is.
  StoreThread(std::filesystem::path file, int months);
  /// Writes what is left, then ends.
  ~StoreThread();
  StoreThread(const StoreThread&) = delete;
  StoreThread& operator=(const StoreThread&) = delete;

  /// Main's: never waits for the disk.
  void visit(VisitRecord visit) { hand_over(std::move(visit)); }
  void keepsake(KeepsakeRecord keepsake) { hand_over(std::move(keepsake)); }
  /// Main's: what staff should know, a Problem once.
  std::vector<Problem> remarks();
  /// Waits until all that was handed over has been tried.
  void finish();

 private:
  using Job = std::variant<VisitRecord, KeepsakeRecord>;
  void hand_over(Job job);
  void run();
  bool open();
  void write(std::deque<Job>& jobs);
  void sweep();
  void say(const Problem& problem);

  const std::filesystem::path file_;
  const int months_;
  std::optional<VisitStore> store_;  ///< Its thread's.
  std::string last_said_;            ///< Likewise: a trouble that lasts is said once.

  std::mutex mutex_;  ///< Of what follows; held for a swap, never over a write.
  std::condition_variable wake_, idle_;
  std::deque<Job> jobs_;
  std::vector<Problem> remarks_;
  bool working_ = false, stop_ = false;
  std::thread thread_;
};

}  // namespace onggi::store
