#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/content/keepsake_names.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace onggi::desk {

/// The keepsakes of an exhibit, as staff at the desk look for them.
struct Kept {
  std::filesystem::path folder;
  std::string language;  ///< Names are said in it.
  content::KeepsakeNames names;
  std::vector<souvenir::NamedVisit> visits;  ///< Newest first.

  /// "quiet blue heron", or "(no name)".
  std::string said(const souvenir::NamedVisit& one) const;
  /// By a word or all of its name in any language, or by how its time begins ("2026-05-04 14:15").
  std::vector<souvenir::NamedVisit> called(const std::string& typed) const;
};

/// "2026-05-04" of a visit's name, its "14:15:03", and the id of its vessel.
std::string day_of(const std::string& visit);
std::string time_of(const std::string& visit);
std::string vessel_of(const std::string& visit);

/// "moon jar" of "moon_jar".
std::string in_words(std::string id);

/// "2026-05-04_1415" of "2026-05-04 14:15": how the names of such visits begin.
std::string stamp_of(std::string typed);

/// Where an exhibit's keepsakes are. Empty values: the exhibit's own.
struct Where {
  std::filesystem::path config;     ///< exhibit.toml
  std::filesystem::path keepsakes;  ///< Their folder.
  std::string language;             ///< To say names in.
};
/// Lists them, and reads the words of names; `remarks` are about those. Problem, exit 2: the folder
/// cannot be read. Blocks on the disk.
Result<Kept> open_kept(const Where& where, std::vector<Problem>& remarks);

}  // namespace onggi::desk
