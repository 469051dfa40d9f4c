#include "kiosk/keepsake/store/store_copy.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "kiosk/ground/files/descriptor.h"

namespace fs = std::filesystem;

namespace onggi::store {

namespace {

/// The signs of a changed file. The log's header has a number that changes whenever the log
/// restarts, which size and time of a short log may not show.
struct Looks {
  std::uintmax_t size = 0;
  fs::file_time_type time;
  std::array<char, 32> header{};
  friend bool operator==(const Looks&, const Looks&) = default;
};

Looks looks_of(const fs::path& file) {
  Looks looks;
  std::error_code size, time;
  looks.size = fs::file_size(file, size);
  looks.time = fs::last_write_time(file, time);
  // A pipe would make us wait for ever.
  const files::Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (opened.open())
    static_cast<void>(::pread(opened.get(), looks.header.data(), looks.header.size(), 0) > 0);
  return looks;
}

}  // namespace

CopyFolder::CopyFolder() {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "onggi-stats-XXXXXX").string();
  if (!error && mkdtemp(name.data()) != nullptr) path_ = name;
}

CopyFolder::~CopyFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

bool copy_still(const fs::path& file, const fs::path& to, const std::function<void()>& meanwhile) {
  const fs::path log = file.string() + "-wal", copy_log = to.string() + "-wal";
  const Looks before = looks_of(file), log_before = looks_of(log);
  std::error_code error, ignored;
  if (fs::exists(log, ignored) && !fs::is_regular_file(log, ignored)) return false;
  fs::remove(copy_log, ignored);
  fs::copy_file(file, to, fs::copy_options::overwrite_existing, error);
  if (error) return false;
  if (meanwhile) meanwhile();
  if (fs::exists(log, ignored))
    fs::copy_file(log, copy_log, fs::copy_options::overwrite_existing, error);
  return !error && before == looks_of(file) && log_before == looks_of(log);
}

}  // namespace onggi::store
