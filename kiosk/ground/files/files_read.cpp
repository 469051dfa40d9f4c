#include "kiosk/ground/files/files_read.h"

#include <mutex>
#include <set>
#include <utility>

namespace onggi::files {
namespace {

struct Ledger {
  std::mutex mutex;
  bool on = true;
  std::set<std::pair<dev_t, ino_t>> files;
};

Ledger& ledger() {
  static Ledger one;
  return one;
}

}  // namespace

void note_read(const struct stat& file) {
  Ledger& all = ledger();
  const std::lock_guard lock(all.mutex);
  if (all.on) all.files.emplace(file.st_dev, file.st_ino);
}

void note_reads(bool on) {
  Ledger& all = ledger();
  const std::lock_guard lock(all.mutex);
  all.on = on;
  if (!on) all.files.clear();
}

bool was_read(const struct stat& file) {
  Ledger& all = ledger();
  const std::lock_guard lock(all.mutex);
  return all.files.contains({file.st_dev, file.st_ino});
}

}  // namespace onggi::files
