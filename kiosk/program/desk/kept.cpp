#include "kiosk/program/desk/kept.h"

#include <algorithm>
#include <utility>

#include "kiosk/collection/settings/exhibit.h"

namespace onggi::desk {

namespace fs = std::filesystem;

std::string Kept::said(const souvenir::NamedVisit& one) const {
  return one.spoken.empty() ? "(no name)" : names.said(one.spoken, language);
}

std::vector<souvenir::NamedVisit> Kept::called(const std::string& typed) const {
  std::vector<souvenir::NamedVisit> found;
  for (const souvenir::NamedVisit& one : visits)
    if (one.visit.starts_with(stamp_of(typed)) ||
        (!one.spoken.empty() && names.matches(one.spoken, typed)))
      found.push_back(one);
  return found;
}

std::string day_of(const std::string& visit) { return visit.substr(0, 10); }

std::string time_of(const std::string& visit) {
  return visit.substr(11, 2) + ':' + visit.substr(13, 2) + ':' + visit.substr(15, 2);
}

std::string vessel_of(const std::string& visit) { return visit.substr(18); }

std::string in_words(std::string id) {
  std::replace(id.begin(), id.end(), '_', ' ');
  return id;
}

std::string stamp_of(std::string typed) {
  if (typed.size() <= 10 || typed[10] != ' ') return typed;
  typed[10] = '_';
  std::erase(typed, ':');
  return typed;
}

Result<Kept> open_kept(const Where& where, std::vector<Problem>& remarks) {
  const settings::Exhibit exhibit = settings::read_exhibit(where.config).exhibit;
  Kept kept;
  kept.folder = where.keepsakes.empty() ? exhibit.keepsake.folder : where.keepsakes;
  kept.language = !where.language.empty()     ? where.language
                  : exhibit.languages.empty() ? "en"
                                              : exhibit.languages.front();
  auto names = content::KeepsakeNames::read(content::names_file(where.config));
  remarks.insert(remarks.end(), names.problems.begin(), names.problems.end());
  kept.names = std::move(names.names);
  std::error_code error;
  const fs::directory_iterator readable(kept.folder, error);
  if (error)
    return problem(kept.folder.string(), "The keepsakes cannot be read: " + error.message() + ".",
                   "Type sudo before the command, or name their folder with --keepsakes.");
  kept.visits = souvenir::named_visits(kept.folder);
  return kept;
}

}  // namespace onggi::desk
