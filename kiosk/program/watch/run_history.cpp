#include "kiosk/program/watch/run_history.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/read_file.h"

namespace fs = std::filesystem;

namespace onggi::watch {

namespace {

constexpr std::size_t kMostOfALedger = 256;
constexpr int kMostKept = 1000;

struct Entry {
  bool running = false;
  int crashes = 0;
};

Entry read_entry(const fs::path& file) {
  const auto bytes = files::read_file(file, kMostOfALedger);
  if (!bytes) return {};
  int running = 0, crashes = 0, end = 0;
  const std::string text(bytes->begin(), bytes->end());
  if (std::sscanf(text.c_str(), "onggi-runs 1 running %1d crashes %4d.%n", &running, &crashes,
                  &end) != 2 ||
      end == 0 || running < 0 || crashes < 0)
    return {};
  return {running == 1, std::min(crashes, kMostKept)};
}

}  // namespace

RunHistory::RunHistory(fs::path folder) : file_(std::move(folder) / "runs") {
  const Entry last = read_entry(file_);
  crashes_ = last.running ? last.crashes + 1 : 0;
}

Result<void> RunHistory::begin() {
  if (auto made = files::make_folder(file_.parent_path()); !made) return made;
  return write(true, crashes_);
}

Result<void> RunHistory::lasted(double seconds) {
  if (steady_ || seconds < kSteady) return {};
  steady_ = true;
  // Whatever ends the run from here on, it is not a crash at the start. crashes() stays, because
  // this run keeps showing the same exhibit.
  return write(false, 0);
}

Result<void> RunHistory::ended() { return write(false, 0); }

Result<void> RunHistory::write(bool running, int crashes) {
  const std::string text = "onggi-runs 1 running " + std::to_string(running ? 1 : 0) + " crashes " +
                           std::to_string(crashes) + ".\n";
  return files::write_durably(file_, std::as_bytes(std::span(text)));
}

}  // namespace onggi::watch
