#include "kiosk/exhibit/reload.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "kiosk/exhibit/log.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

namespace {

constexpr double kLookAgain = 5.0;  // s

/// Without line and column: an edit above moves what stays as wrong as it was.
std::string name_of(const Problem& problem) {
  return problem.where.substr(0, problem.where.find(':')) + ": " + problem.what;
}

/// Those of the files that were looked at, those above, where another vessel may be put, and those
/// that lie there already and hold none yet: a copy may be on its way.
std::vector<fs::path> folders_of(const CheckReport& report) {
  std::set<fs::path> folders;
  for (const fs::path& file : report.files) {
    folders.insert(file.parent_path());
    folders.insert(file.parent_path().parent_path());
  }
  std::set<fs::path> all = folders;
  for (const fs::path& folder : folders) {
    std::error_code gone;
    for (fs::directory_iterator it(folder, gone), end; !gone && it != end; it.increment(gone))
      if (std::error_code unknown; it->is_directory(unknown)) all.insert(it->path());
  }
  return {all.begin(), all.end()};
}

}  // namespace

Reload::Reload(fs::path exhibit) : exhibit_(std::move(exhibit)) { begin_check(); }

// The check is waited for: for a vessel at most, and not for the whole shelf.
Reload::~Reload() { stop_.request_stop(); }

void Reload::begin_check() {
  check_ = std::async(std::launch::async, [file = exhibit_.string(), stop = stop_.get_token()] {
    setpriority(PRIO_PROCESS, 0, 19);  // this thread alone: a visitor's picture comes first
    return check_path("", file, stop);
  });
}

void Reload::look(double now) {
  if (files_ && files_->changed(now)) again_ = true;
  if (check_.valid()) {
    if (check_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    const Result<CheckReport> report = check_.get();
    if (report)
      take(*report, now);
    else
      log_problem(report.error());
  }
  if (look_again_at_ >= 0.0 && now >= look_again_at_) again_ = true;
  if (!std::exchange(again_, false)) return;
  look_again_at_ = -1.0;
  begin_check();
}

void Reload::take(const CheckReport& report, double now) {
  // The folders may be others now; but a change that the old watch saw begin is its to tell.
  if (files_ == nullptr || !files_->pending())
    files_ = std::make_unique<watch::FileWatch>(folders_of(report));
  std::set<std::string> found;
  for (const Problem& problem : report.problems) found.insert(name_of(problem));
  if (!known_) {
    known_ = std::move(found);
    log_line("Changes of the exhibit are looked for in " + std::to_string(files_->watched()) +
             " folders.");
    return;
  }
  wanted_ = std::includes(known_->begin(), known_->end(), found.begin(), found.end());
  if (wanted_)
    log_line("The exhibit has changed, and is opened anew once no visitor is here.");
  else
    refuse(report, std::move(found), now);
}

void Reload::refuse(const CheckReport& report, std::set<std::string> found, double now) {
  if (found == refused_) return;
  log_line("A change of the exhibit is not taken up. It goes on as it was, until this is mended:");
  for (const Problem& problem : report.problems)
    if (known_->count(name_of(problem)) == 0) log_problem(problem);
  refused_ = std::move(found);
  // A copy may have come to its end between the check and the watch: what is still as wrong then
  // is.
  look_again_at_ = now + kLookAgain;
}

}  // namespace onggi::exhibit
