#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "kiosk/collection/content/catalogue.h"

namespace onggi::exhibit {

/// Passes entries of a shelf from the reading threads to the main thread. Entries come in the order
/// of the shelf, but no vessel waits longer than kPatience for a slow one, which then comes last.
class Arrivals : public content::ShelfWatcher {
 public:
  static constexpr double kPatience = 2.0;  ///< Seconds.
  using Read = Result<std::vector<content::Vessel>>;

  void begins(std::size_t at, std::size_t total, const std::string& id) override;
  void has_read(std::size_t at, Read read) override;
  /// No more entries will be read.
  void finish();

  struct Progress {
    int done = 0, total = 0;
  };
  Progress progress() const;
  /// The entries to show at `now`, in seconds of a clock that runs forwards; each once.
  std::vector<Read> take(double now);
  /// True if every entry was read and taken.
  bool over() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::size_t, Read> waiting_;
  std::vector<bool> taken_;
  std::size_t next_ = 0, read_ = 0, total_ = 0;
  double since_ = -1.0;  // when an entry began to wait for an earlier one
  bool finished_ = false;
};

}  // namespace onggi::exhibit
