#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/web/message.h"

namespace onggi::console {

/// What the staff's page says in other languages than English, from content/staff/CODE.toml: its
/// name, whether it is written from right to left, and two tables with the English as the key.
/// [page] is for everybody, [editors] for what editors alone see. Anybody may read them: they are
/// the program's, and say nothing of an exhibit.
class PageWords {
 public:
  PageWords() = default;
  /// Every language in `folder`; none where it is not there, which `remarks` say. What is wrong
  /// with a file goes there, too, and the page speaks that language no more.
  PageWords(const std::filesystem::path& folder, std::vector<Problem>& remarks);
  /// Beside or above the program `onggi_console`, in the build folder or where it is installed; "":
  /// nowhere.
  static std::filesystem::path folder_of(const std::filesystem::path& onggi_console);

  /// GET /words: {CODE: name}. /words/CODE: {name, right_to_left, page}. /words/CODE/editors:
  /// {editors}. Absent for other addresses.
  std::optional<web::Answer> to(const web::Ask& ask) const;

 private:
  std::map<std::string, std::string> answers_;  // the JSON at each address
};

}  // namespace onggi::console
