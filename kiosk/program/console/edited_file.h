#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/changes/draft.h"
#include "kiosk/ground/fields/field.h"
#include "kiosk/program/console/site.h"

namespace onggi::console {

class LineKeys;

/// What is wrong with a change.
struct ChangeFault {
  std::string key;  ///< As it was sent; "": of no single value.
  std::string what, remedy;
};

/// The scenes that the page tells of and changes: those in `scenes` beside the exhibit's own file,
/// by name.
std::vector<std::filesystem::path> scene_files(const Site& site);

/// A curator's file as the page changes it. Reads the disk at each call. One thread.
class EditedFile {
 public:
  /// "exhibit"; "missions", "glazes", "lesson" or "build_lesson", where the exhibit has one;
  /// "vessel/ID" of a folder on the shelf, "scene/NAME" of scene_files(), "language/CODE" of the
  /// site's own. None for all else.
  static std::optional<EditedFile> find(Site& site, const std::string& name);

  const std::filesystem::path& path() const { return path_; }
  /// Its keys that may be changed here: none that names a place on the machine, but a scene among
  /// scene_files().
  const fields::FieldList& fields() const { return list_; }
  /// Its text. Problem where it cannot be read, or is no TOML.
  Result<std::string> text() const;
  /// The changes that `body` asks for, {"changes": [[key, value], ...]}; null takes a key out. None
  /// where it has another form.
  std::optional<std::vector<changes::Change>> changes_in(const std::string& body) const;
  /// `text` with `wanted`; what cannot be made is left out, and told in `faults`.
  changes::Draft draft_of(const std::string& text, const std::vector<changes::Change>& wanted,
                          std::vector<ChangeFault>& faults) const;
  /// The same, and `faults` has faults_of() as well.
  changes::Draft checked(const std::string& text, const std::vector<changes::Change>& wanted,
                         std::vector<ChangeFault>& faults) const;
  /// What is absent or wrong in the file as it is, where a field of it is meant.
  std::vector<ChangeFault> gaps(const std::string& text) const;
  /// What the file's own reader, as `onggi check` uses it, finds wrong in `draft` and not in
  /// `text`. Other files are not looked at, so that it takes a few ms.
  std::vector<ChangeFault> faults_of(const changes::Draft& draft, const std::string& text) const;

 private:
  /// What its own reader finds wrong in the file, with words in all of the languages.
  using Reader = std::vector<Problem> (*)(const std::filesystem::path&,
                                          const std::vector<std::string>&);
  EditedFile(std::filesystem::path path, std::vector<std::string> languages,
             const fields::FieldList& all, Reader reader);
  /// False for a scene that is not among scene_files().
  bool is_offered(const changes::Change& change) const;
  /// The key that is absent, by a `problem` that is told of its table or of none: "title.fr",
  /// "label.en.culture", "hours.every_day". "" of another problem.
  bool is_unfinished_vessel(const std::string& text) const;
  std::string missing_key(const LineKeys& lines, const std::string& text,
                          const Problem& problem) const;

  std::filesystem::path path_;
  std::vector<std::string> languages_;
  fields::FieldList list_;
  Reader reader_;
};

}  // namespace onggi::console
