#include "kiosk/ground/files/files_read.h"

#include <mutex>
#include <set>
#include <utility>

namespace onggi::files {
namespace {

struct Ledger {
  std::mutex mutex;
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
  all.files.emplace(file.st_dev, file.st_ino);
}

bool was_read(const struct stat& file) {
  Ledger& all = ledger();
  const std::lock_guard lock(all.mutex);
  return all.files.contains({file.st_dev, file.st_ino});
}

}  // namespace onggi::files
