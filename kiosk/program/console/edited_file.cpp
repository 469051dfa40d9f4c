#include "kiosk/program/console/edited_file.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "kiosk/collection/changes/typed_value.h"
#include "kiosk/collection/content/content_fields.h"
#include "kiosk/collection/content/glaze.h"
#include "kiosk/collection/content/language.h"
#include "kiosk/collection/content/lesson.h"
#include "kiosk/collection/content/pack.h"
#include "kiosk/collection/content/word_fields.h"
#include "kiosk/collection/settings/exhibit_fields.h"
#include "kiosk/collection/settings/mission_fields.h"
#include "kiosk/collection/settings/mission_file.h"
#include "kiosk/collection/settings/scene_file.h"
#include "kiosk/collection/settings/scene_file_fields.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/toml/stand_in.h"
#include "kiosk/ground/toml/toml_places.h"
#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/ground/toml/toml_splice.h"
#include "kiosk/ground/toml/toml_text.h"
#include "kiosk/program/console/line_keys.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
using fields::FieldKind;

constexpr std::size_t kMostChanges = 100;  // of 10 ms each in a large file

/// A value of JSON as a person would type it, or as TOML writes it; none for an object, unless it
/// is empty, which is a new table.
std::optional<std::string> written(const nlohmann::json& value, const fields::Field* field) {
  if (value.is_object() && value.empty()) return changes::kNewTable;
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_number_integer()) return std::to_string(value.get<std::int64_t>());
  if (value.is_number()) return fields::number_words(value.get<double>());
  if (value.is_string()) {
    const bool text = field == nullptr || field->kind == FieldKind::text;
    return text ? toml::quoted_text(value.get<std::string>()) : value.get<std::string>();
  }
  if (!value.is_array()) return std::nullopt;
  std::string list;
  for (const nlohmann::json& one : value) {
    if (one.is_array()) return std::nullopt;  // no file has lists in lists
    const auto element = written(one, nullptr);
    if (!element) return std::nullopt;
    list += (list.empty() ? "" : ", ") + *element;
  }
  return '[' + list + ']';
}

/// Without line and column, because a change above moves an old Problem.
std::string name_of(const Problem& problem) {
  return problem.where.substr(0, problem.where.find(':')) + ": " + problem.what;
}

// Where files lie, how phones reach the kiosk and how much it takes in are for whoever keeps the
// machine: a page must not lead the kiosk, or itself, to other folders. By table and key.
const std::set<std::string> kMachinesOwn{"shelf",           "vessel_scenes", "rubric", "lesson",
                                         "build_lesson",    "glazes",        "ways",   "missions",
                                         "keepsake.folder", "phone",         "reader"};
// The last limit on forces, and the published model, which is for comparison.
const std::set<std::string> kMakersOwn{"guard", "paper"};
const std::set<std::string> kFilesOwn{"drawing", "decoration", "node", "units", "up", "color"};
// The name of an element is how others know it.
const std::set<std::string> kElementNames{"mission.id", "glaze.id", "step.id"};

const std::set<std::string>& left_out_of(const fields::FieldList& list) {
  if (&list == &settings::exhibit_fields()) return kMachinesOwn;
  if (&list == &settings::scene_fields()) return kMakersOwn;
  return &list == &content::vessel_fields() ? kFilesOwn : kElementNames;
}

std::vector<Problem> of_exhibit(const fs::path& file, const std::vector<std::string>&) {
  return settings::read_exhibit(file, files::language_folder(file)).problems;
}
std::vector<Problem> of_vessel(const fs::path& file, const std::vector<std::string>& languages) {
  content::PackRead read = content::read_pack(file, languages);
  std::vector<Problem> out = std::move(read.problems);
  out.insert(out.end(), read.advice.begin(), read.advice.end());
  return out;
}
std::vector<Problem> of_missions(const fs::path& file, const std::vector<std::string>& languages) {
  return settings::read_missions(file, languages).problems;
}
std::vector<Problem> of_glazes(const fs::path& file, const std::vector<std::string>& languages) {
  return content::read_glazes(file, languages).problems;
}
std::vector<Problem> of_scene(const fs::path& file, const std::vector<std::string>&) {
  return settings::read_scene(file).problems;
}
std::vector<Problem> of_language(const fs::path& file, const std::vector<std::string>&) {
  content::LanguageRead read = content::check_language(file);
  std::ranges::move(read.advice, std::back_inserter(read.problems));
  return std::move(read.problems);
}
std::vector<Problem> of_lesson(const fs::path& file, const std::vector<std::string>& languages) {
  return content::read_lesson(file, languages).problems;
}

fs::path scene_folder(const Site& site) { return site.file().parent_path() / "scenes"; }

/// True of a key whose value is one of scene_files().
bool names_a_scene(const fields::Field& field) {
  return field.table.empty() && (field.key == "scene" || field.key == "built_scene");
}

/// "title" and "fr" of `There is no title in the language "fr".`; nothing of another sentence.
std::pair<std::string, std::string> lacking_in(const std::string& what) {
  for (const std::string_view between : {" in the language \"", " for the language \""}) {
    const std::size_t at = what.find(between);
    if (at == std::string::npos) continue;
    const std::size_t word = what.rfind(' ', at - 1) + 1, code = at + between.size();
    return {what.substr(word, at - word), what.substr(code, what.find('"', code) - code)};
  }
  return {};
}

bool is_a_folders_name(const std::string& id) {
  return !id.empty() && id[0] != '.' && id.find('/') == std::string::npos &&
         std::ranges::none_of(id, [](char c) { return c >= 0 && c < ' '; });
}

}  // namespace

EditedFile::EditedFile(fs::path path, std::vector<std::string> languages,
                       const fields::FieldList& all, Reader reader)
    : path_(std::move(path)), languages_(std::move(languages)), reader_(reader) {
  const std::set<std::string>& left_out = left_out_of(all);
  list_.file = all.file;
  list_.tables = all.tables;
  std::ranges::copy_if(all.fields, std::back_inserter(list_.fields), [&](const fields::Field& f) {
    return !left_out.contains(f.table) && !left_out.contains(f.name());
  });
}

std::optional<EditedFile> EditedFile::find(Site& site, const std::string& name) {
  const settings::Exhibit& exhibit = site.exhibit();
  const std::vector<std::string>& languages = exhibit.languages;
  std::error_code error;
  const auto there = [&](const std::optional<fs::path>& file, const fields::FieldList& list,
                         Reader reader) -> std::optional<EditedFile> {
    if (!file || !fs::is_regular_file(*file, error)) return std::nullopt;
    return EditedFile(*file, languages, list, reader);
  };
  if (name == "exhibit") {
    auto out = there(site.file(), settings::exhibit_fields(), of_exhibit);
    if (!out) return out;
    std::vector<std::string> scenes;
    for (const fs::path& scene : scene_files(site))
      scenes.push_back("scenes/" + scene.filename().string());
    for (fields::Field& field : out->list_.fields)
      if (names_a_scene(field)) field.choices = scenes;
    return out;
  }
  if (name == "missions") return there(exhibit.missions, settings::mission_fields(), of_missions);
  if (name == "glazes") return there(exhibit.glazes, content::glaze_fields(), of_glazes);
  if (name == "lesson") return there(exhibit.lesson, content::lesson_fields(), of_lesson);
  if (name == "build_lesson")
    return there(exhibit.build_lesson, content::lesson_fields(), of_lesson);
  const std::size_t slash = name.find('/');
  const std::string kind = name.substr(0, slash),
                    id = slash == std::string::npos ? "" : name.substr(slash + 1);
  if (!is_a_folders_name(id)) return std::nullopt;
  if (kind == "vessel")
    return there(exhibit.shelf / id / "vessel.toml", content::vessel_fields(), of_vessel);
  if (kind == "scene")
    return there(scene_folder(site) / (id + ".toml"), settings::scene_fields(), of_scene);
  // The site's own words, and not those of the program.
  if (kind == "language")
    return there(site.file().parent_path().parent_path() / "content/languages" / (id + ".toml"),
                 content::word_fields(), of_language);
  return std::nullopt;
}

std::vector<fs::path> scene_files(const Site& site) {
  std::vector<fs::path> out;
  std::error_code gone;
  for (fs::directory_iterator it(scene_folder(site), gone), end; !gone && it != end;
       it.increment(gone))
    if (it->path().extension() == ".toml" && it->is_regular_file(gone)) out.push_back(it->path());
  std::ranges::sort(out);
  return out;
}

Result<std::string> EditedFile::text() const {
  auto text = toml::read_toml_text(path_);
  if (!text) return text;
  const toml::TomlReader reader = toml::TomlReader::of_text(*text, path_.string());
  if (!reader.ok()) return tl::unexpected(reader.problems().front());
  return text;
}

std::optional<std::vector<changes::Change>> EditedFile::changes_in(const std::string& body) const {
  const nlohmann::json object = nlohmann::json::parse(body, nullptr, false);
  if (!object.is_object() || !object.contains("changes")) return std::nullopt;
  const nlohmann::json& list = object["changes"];
  if (!list.is_array() || list.size() > kMostChanges) return std::nullopt;
  std::vector<changes::Change> out;
  for (const nlohmann::json& one : list) {
    if (!one.is_array() || one.size() != 2 || !one[0].is_string()) return std::nullopt;
    changes::Change change{one[0].get<std::string>(), std::nullopt};
    if (!one[1].is_null()) {
      toml::Path names = toml::path_of(change.key);
      // The field of an element: without its id.
      const bool element = std::ranges::any_of(list_.tables, [&](const fields::OptionalTable& t) {
        return t.is_list && names.size() > 2 && names.front() == t.name;
      });
      if (element) names.erase(names.begin() + 1);
      change.value = written(one[1], fields::find_field(list_, names));
      if (!change.value) return std::nullopt;
    }
    out.push_back(std::move(change));
  }
  return out;
}

changes::Draft EditedFile::draft_of(const std::string& text,
                                    const std::vector<changes::Change>& wanted,
                                    std::vector<ChangeFault>& faults) const {
  changes::Draft draft{text, {}, false};
  for (const changes::Change& change : wanted)
    if (!is_offered(change))
      faults.push_back({change.key, "There is no such scene.",
                        "Choose one of the files in scenes, beside the exhibit's own file."});
    else if (const auto made =
                 changes::make_change(draft, &list_, change, path_.filename().string());
             !made)
      faults.push_back({change.key, made.error().what, made.error().remedy});
  return draft;
}

bool EditedFile::is_offered(const changes::Change& change) const {
  const fields::Field* field = fields::find_field(list_, toml::path_of(change.key));
  if (field == nullptr || !names_a_scene(*field) || !change.value) return true;
  return std::ranges::any_of(field->choices, [&](const std::string& choice) {
    return *change.value == toml::quoted_text(choice);
  });
}

bool EditedFile::is_unfinished_vessel(const std::string& text) const {
  bool unfinished = false;
  toml::TomlReader reader = toml::TomlReader::of_text(text, path_.string());
  if (path_.filename() == "vessel.toml") reader.root().boolean("unfinished", unfinished);
  return unfinished;
}

std::vector<ChangeFault> EditedFile::faults_of(const changes::Draft& draft,
                                               const std::string& text) const {
  if (draft.text == text) return {};
  std::vector<Problem> after;
  {
    const toml::StandIn change(path_, draft.text);
    after = reader_(path_, languages_);
  }
  if (after.empty()) return {};
  std::set<std::string> before;
  // What an unfinished vessel lacks is a fault as soon as visitors shall see it.
  const bool finishes = std::ranges::any_of(draft.values, [](const changes::ChangedValue& value) {
    return value.key == "unfinished" && value.is != "true";
  });
  if (!finishes)
    for (const Problem& problem : reader_(path_, languages_)) before.insert(name_of(problem));
  std::map<std::string, std::string> keys_by_line;  // of what was changed
  for (const changes::ChangedValue& value : draft.values)
    keys_by_line.emplace(changes::line_of_key(draft.text, path_.string(), value.key), value.key);
  const LineKeys lines(draft.text, path_.string());
  std::vector<ChangeFault> out;
  const bool unfinished = is_unfinished_vessel(draft.text);
  for (const Problem& problem : after) {
    if (before.contains(name_of(problem))) continue;
    if (const std::string key = missing_key(lines, draft.text, problem); !key.empty()) {
      // A label may be written in several goes; a title makes it one.
      if (unfinished && !key.ends_with(".title")) continue;
      out.push_back({key, problem.what, "Write it here."});  // no line of the file: a field
      continue;
    }
    // "name:12:" of "name:12:3"
    const auto of = keys_by_line.find(problem.where.substr(0, problem.where.rfind(':') + 1));
    out.push_back({of == keys_by_line.end() ? "" : of->second, problem.what, problem.remedy});
  }
  std::stable_partition(out.begin(), out.end(),
                        [](const ChangeFault& fault) { return !fault.key.empty(); });
  return out;
}

changes::Draft EditedFile::checked(const std::string& text,
                                   const std::vector<changes::Change>& wanted,
                                   std::vector<ChangeFault>& faults) const {
  changes::Draft draft = draft_of(text, wanted, faults);
  for (ChangeFault& fault : faults_of(draft, text)) faults.push_back(std::move(fault));
  return draft;
}

std::vector<ChangeFault> EditedFile::gaps(const std::string& text) const {
  std::vector<ChangeFault> out;
  const LineKeys lines(text, path_.string());
  for (const Problem& problem : reader_(path_, languages_)) {
    std::string key = missing_key(lines, text, problem);
    if (const auto* value = lines.value_at(problem); key.empty() && value != nullptr)
      key = toml::key_text(value->path);
    if (!key.empty()) out.push_back({key, problem.what, problem.remedy});
  }
  return out;
}

std::string EditedFile::missing_key(const LineKeys& lines, const std::string& text,
                                    const Problem& problem) const {
  if (problem.what.starts_with("the true size is missing")) return "true_height_mm";
  if (problem.what.starts_with("There are no hours for ")) return "hours.every_day";
  if (problem.what.ends_with(" is missing.")) {
    // "label.en.culture is missing.", "attract.begin is missing." of [text]
    const std::string name = problem.what.substr(0, problem.what.find(' '));
    for (const std::string& key : {name, "text." + name})
      if (fields::find_field(list_, toml::path_of(key)) != nullptr)
        return toml::key_text(toml::path_of(key));
  }
  const auto [word, language] = lacking_in(problem.what);
  const toml::TomlPlaces::Header* header = lines.header_at(problem);
  if (language.empty() || header == nullptr) return {};
  const toml::Path list(header->path.begin(), header->path.end() - 1);
  const bool element = lines.places().elements(list) > 0;
  toml::Path names = element ? list : header->path, path = header->path;
  if (element) {
    path.push_back(word);
    names.push_back(word);
  }
  path.push_back(language);
  names.push_back(language);
  const fields::Field* field = fields::find_field(list_, names);
  if (field == nullptr || !field->any_key) return {};
  const auto typed = changes::typed_key(text, lines.places(), toml::key_text(path), "");
  return typed ? typed->shown : "";
}

}  // namespace onggi::console
