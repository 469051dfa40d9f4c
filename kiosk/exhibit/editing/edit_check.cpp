#include "kiosk/exhibit/editing/edit_check.h"

#include <algorithm>
#include <set>
#include <vector>

#include "kiosk/exhibit/composition/check_exhibit.h"
#include "kiosk/exhibit/composition/file_kind.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/toml/stand_in.h"

namespace onggi::editing {
namespace {

namespace fs = std::filesystem;

/// Without line and column, because a change above moves an old Problem.
std::string name_of(const Problem& problem) {
  return problem.where.substr(0, problem.where.find(':')) + ": " + problem.what;
}

/// Every fault of the exhibit that `file` belongs to, and of `file`.
std::vector<Problem> faults_with(const fs::path& file) {
  std::vector<Problem> out;
  const auto take = [&out](const Result<exhibit::CheckReport>& report) {
    if (report)
      out.insert(out.end(), report->problems.begin(), report->problems.end());
    else
      out.push_back(report.error());
  };
  if (exhibit::kind_of_toml(file) == exhibit::FileKind::exhibit) {
    take(exhibit::check_path(file.string()));
    return out;
  }
  const fs::path site = files::site_exhibit(file);
  if (!site.empty()) {
    const auto report = exhibit::check_path("", site.string());
    take(report);
    const fs::path real = files::real_path(file);
    if (report && std::ranges::any_of(report->files, [&real](const fs::path& read) {
          return files::real_path(read) == real;
        }))
      return out;
  }
  take(exhibit::check_path(file.string()));
  return out;
}

/// Calls the file as it was named, where the exhibit's check has its whole path.
void call_as(const fs::path& file, Problem& problem) {
  const std::size_t end = std::min(problem.where.find(':'), problem.where.size());
  if (files::real_path(problem.where.substr(0, end)) == files::real_path(file))
    problem.where = file.string() + problem.where.substr(end);
}

}  // namespace

std::vector<Problem> new_faults(const fs::path& file, const std::string& text) {
  std::vector<Problem> after;
  {
    const toml::StandIn change(file, text);
    after = faults_with(file);
  }
  if (after.empty()) return after;
  std::set<std::string> before;
  for (const Problem& problem : faults_with(file)) before.insert(name_of(problem));
  std::erase_if(after,
                [&before](const Problem& problem) { return before.contains(name_of(problem)); });
  for (Problem& problem : after) call_as(file, problem);
  return after;
}

}  // namespace onggi::editing
