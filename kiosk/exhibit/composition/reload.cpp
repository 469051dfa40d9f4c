#include "kiosk/exhibit/composition/reload.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/device_files.h"
#include "kiosk/ground/files/log.h"
#include "kiosk/ground/files/paths.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

namespace {

constexpr double kLookAgain = 5.0;  // s

/// Without line and column, because an edit above moves an old Problem.
std::string name_of(const Problem& problem) {
  return problem.where.substr(0, problem.where.find(':')) + ": " + problem.what;
}

/// The folders of all files that the exhibit uses. Not the keepsakes', which change with every
/// visitor.
std::vector<fs::path> folders_of(const fs::path& file) {
  const settings::Exhibit exhibit = settings::read_exhibit(file).exhibit;
  // Watch the site's folder too: its config/ may be a link that changes, or may be replaced.
  std::set<fs::path> folders = {files::site_exhibit(file).parent_path().parent_path(),
                                file.parent_path(),
                                exhibit.rubric_file.parent_path(),
                                exhibit.scene.parent_path(),
                                exhibit.glazes.parent_path(),
                                device_file(exhibit, device::DeviceKind::space_mouse).parent_path(),
                                files::language_folder(file),
                                exhibit.shelf};
  for (const auto& [vessel, scene] : exhibit.vessel_scenes) folders.insert(scene.parent_path());
  if (exhibit.built_scene) folders.insert(exhibit.built_scene->parent_path());
  if (exhibit.lesson) folders.insert(exhibit.lesson->parent_path());
  if (exhibit.build_lesson) folders.insert(exhibit.build_lesson->parent_path());
  if (exhibit.ways) folders.insert(*exhibit.ways);
  if (exhibit.missions) folders.insert(exhibit.missions->parent_path());
  std::error_code gone;
  for (fs::recursive_directory_iterator it(exhibit.shelf, gone), end; !gone && it != end;
       it.increment(gone))
    if (std::error_code unknown; it->is_directory(unknown)) folders.insert(it->path());
  const fs::path keepsakes = exhibit.keepsake.folder.lexically_normal();
  std::vector<fs::path> wanted;
  for (const fs::path& folder : folders)
    if (!folder.empty() && folder.lexically_normal() != keepsakes) wanted.push_back(folder);
  return wanted;
}

}  // namespace

Reload::Reload(fs::path exhibit, Shown shown)
    : exhibit_(std::move(exhibit)), stands_in_(shown == Shown::another) {
  const auto folders = folders_of(exhibit_);
  files_ = std::make_unique<files::FileWatch>(folders);
  open_ = files::stamps_in(folders);
}

// Wait for the check, which stops after the current vessel.
Reload::~Reload() { stop_.request_stop(); }

void Reload::begin_check() {
  wanted_ = false;  // until the current files are known
  check_ = std::async(std::launch::async, [file = exhibit_.string(), stop = stop_.get_token()] {
    setpriority(PRIO_PROCESS, 0, 19);  // only this thread: a visitor's picture comes first
    auto folders = folders_of(file);
    auto before = files::stamps_in(folders);
    auto report = check_path("", file, stop);
    auto after = files::stamps_in(folders);
    return Checked{std::move(report), std::move(folders), std::move(before), std::move(after)};
  });
}

bool Reload::wanted() const { return wanted_ && !again_ && !check_.valid() && !files_->pending(); }

void Reload::taken_up() {
  wanted_ = stands_in_ = false;
  open_ = seen_;
  known_ = found_;
}

void Reload::look(double now) {
  if (files_->changed(now)) again_ = true;
  if (check_.valid()) {
    if (check_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    take(check_.get(), now);
  }
  if (look_again_at_ >= 0.0 && now >= look_again_at_) again_ = true;
  if (!std::exchange(again_, false)) return;
  look_again_at_ = -1.0;
  begin_check();
}

void Reload::take(const Checked& checked, double now) {
  if (!checked.report) {
    // The exhibit is missing; the old watch knows its place.
    const std::string trouble = to_text(checked.report.error());
    if (std::exchange(trouble_, trouble) != trouble) files::log_problem(checked.report.error());
    look_again_at_ = now + kLookAgain;
    return;
  }
  trouble_.clear();
  // The folders may have changed, but the old watch still reports a change that it saw begin.
  if (!files_->pending()) files_ = std::make_unique<files::FileWatch>(checked.folders);
  // Other files in the folders do not matter.
  const auto& files = checked.report->files;
  seen_ = files::of_files(checked.before, files);
  if (seen_ != files::of_files(checked.after, files)) {
    look_again_at_ = now + kLookAgain;  // they changed during the check, so wait until they settle
    return;
  }
  if (!checked_) open_ = files::of_files(open_, files);
  judge(*checked.report, now);
}

void Reload::judge(const CheckReport& report, double now) {
  found_.clear();
  for (const Problem& problem : report.problems) found_.insert(name_of(problem));
  if (!std::exchange(checked_, true)) {
    files::log_line("Watching for changes of the exhibit in " + std::to_string(files_->watched()) +
                    " folders.");
    if (seen_ == open_ && !stands_in_) known_ = found_;
  }
  if (seen_ == open_) {
    refused_.clear();
    return;
  }
  if (std::any_of(report.problems.begin(), report.problems.end(),
                  [this](const Problem& problem) { return new_to_visitors(problem); }))
    return refuse(report, now);
  wanted_ = true;
  refused_.clear();
  files::log_line("The exhibit has changed. It is opened again when no visitor is here.");
}

bool Reload::new_to_visitors(const Problem& problem) const {
  const std::string name = name_of(problem);
  // The earlier Problems of the museum's other files are not known. A vessel that cannot be read is
  // left out, as at every start.
  if (stands_in_) return name.starts_with(exhibit_.string() + ":");
  return known_.count(name) == 0;
}

void Reload::refuse(const CheckReport& report, double now) {
  if (found_ == refused_) return;
  files::log_line(
      "A change of the exhibit has a fault. The old exhibit stays open until you fix this:");
  for (const Problem& problem : report.problems)
    if (new_to_visitors(problem)) files::log_problem(problem);
  refused_ = found_;
  // A copy may have ended between the check and the watch: keep only Problems that still exist.
  look_again_at_ = now + kLookAgain;
}

}  // namespace onggi::exhibit
