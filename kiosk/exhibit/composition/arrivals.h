#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "kiosk/collection/content/catalogue.h"

namespace onggi::exhibit {

/// Entries of a shelf between the threads that read them and the one that shows them. They are
/// shown in the order of their ids, but no vessel waits longer than kPatience for one that is slow
/// to read: the slow one then comes last.
class Arrivals : public content::ShelfWatcher {
 public:
  static constexpr double kPatience = 2.0;  ///< Seconds.
  using Read = Result<std::vector<content::Vessel>>;

  void begins(std::size_t at, std::size_t total, const std::string& id) override;
  void has_read(std::size_t at, Read read) override;
  /// Nothing more will be read.
  void finish();

  struct Progress {
    int done = 0, total = 0;
  };
  Progress progress() const;
  /// What may be shown from `now` on, in seconds of any clock that runs forwards; each entry once.
  std::vector<Read> take(double now);
  /// Everything was read and taken.
  bool over() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::size_t, Read> waiting_;
  std::vector<bool> taken_;
  std::size_t next_ = 0, read_ = 0, total_ = 0;
  double since_ = -1.0;  // when something began to wait for an earlier entry
  bool finished_ = false;
};

}  // namespace onggi::exhibit
