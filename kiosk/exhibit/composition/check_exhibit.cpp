#include "kiosk/exhibit/composition/check_exhibit.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <utility>

#include "kiosk/collection/content/catalogue.h"
#include "kiosk/collection/content/drawing.h"
#include "kiosk/collection/content/glaze.h"
#include "kiosk/collection/content/keepsake_names.h"
#include "kiosk/collection/content/language.h"
#include "kiosk/collection/content/lesson.h"
#include "kiosk/collection/content/translation_tables.h"
#include "kiosk/collection/decoration/decoration.h"
#include "kiosk/collection/decoration/way.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/collection/settings/scene_file.h"
#include "kiosk/exhibit/composition/check_letters.h"
#include "kiosk/exhibit/composition/device_files.h"
#include "kiosk/exhibit/composition/file_kind.h"
#include "kiosk/exhibit/composition/missions.h"
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/exhibit/composition/ways.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

namespace {

void note(CheckReport& report, int keys, std::vector<Problem> problems) {
  report.keys += keys;
  // If two files lead to a third, it is read twice but reported once.
  for (Problem& p : problems)
    if (std::none_of(report.problems.begin(), report.problems.end(), [&p](const Problem& known) {
          return known.where == p.where && known.what == p.what;
        }))
      report.problems.push_back(std::move(p));
}

void look(CheckReport& report, const fs::path& file) {
  const fs::path plain = file.lexically_normal();
  if (std::find(report.files.begin(), report.files.end(), plain) == report.files.end())
    report.files.push_back(plain);
}

void add(CheckReport& report, const fs::path& file, int keys, std::vector<Problem> problems) {
  look(report, file);
  note(report, keys, std::move(problems));
}

template <class Thing>
std::vector<std::string> ids_of(const std::vector<Thing>& things) {
  std::vector<std::string> ids;
  for (const Thing& thing : things) ids.push_back(thing.id);
  return ids;
}

void check_scene(CheckReport& report, const fs::path& file) {
  auto scene = settings::read_scene(file);
  add(report, file, scene.keys_checked, std::move(scene.problems));
}

void check_language(CheckReport& report, const fs::path& file,
                    const content::KnownIds& known = {}) {
  auto language = content::check_language(file, known);
  ++report.languages;
  add(report, file, language.keys_checked, std::move(language.problems));
  note(report, 0, std::move(language.advice));
}

/// The glazes' ids.
std::vector<std::string> check_glazes(CheckReport& report, const fs::path& file,
                                      const std::vector<std::string>& languages = {},
                                      const settings::Translations& translations = {}) {
  auto glazes = content::read_glazes(file, languages, translations);
  add(report, file, glazes.keys_checked, std::move(glazes.problems));
  return ids_of(glazes.glazes);
}

/// The steps' ids.
std::vector<std::string> check_lesson(CheckReport& report, const fs::path& file,
                                      const std::vector<std::string>& languages = {},
                                      const settings::Translations& translations = {}) {
  auto lesson = content::read_lesson(file, languages, translations);
  add(report, file, lesson.keys_checked, std::move(lesson.problems));
  return ids_of(lesson.steps);
}

void check_names(CheckReport& report, const fs::path& file,
                 const std::vector<std::string>& languages) {
  auto names = content::KeepsakeNames::read(file, languages);
  add(report, file, names.keys_checked, std::move(names.problems));
  report.notes.insert(report.notes.end(), names.notes.begin(), names.notes.end());
}

/// The missions' ids. `exhibit`: their exhibit, null if not known; `shelf`: the ids there.
std::vector<std::string> check_missions(CheckReport& report, const fs::path& file,
                                        const std::vector<std::string>& languages,
                                        const settings::Exhibit* exhibit = nullptr,
                                        const std::vector<std::string>& shelf = {}) {
  auto missions = settings::read_missions(
      file, languages, shelf,
      exhibit != nullptr ? exhibit->translations : settings::Translations{});
  if (exhibit != nullptr) {
    const SceneDef scene = settings::read_scene(exhibit->scene).def;
    toml::TomlReader reader(file);
    auto tables = reader.root().children("mission");
    for (const settings::Mission& mission : missions.missions) {
      if (mission.kind != settings::Mission::Kind::describe) continue;
      const auto jar = jar_for(mission, scene);
      if (jar) continue;
      std::string id;
      for (auto& table : tables)
        if (table.text("id", id) && id == mission.id)
          table.complain("litres", jar.error().what, jar.error().remedy);
    }
    std::ranges::copy(reader.problems(), std::back_inserter(missions.problems));
  }
  add(report, file, missions.keys_checked, std::move(missions.problems));
  return ids_of(missions.missions);
}

content::ShelfCheck check_vessels(CheckReport& report, const fs::path& path,
                                  const std::vector<std::string>& languages,
                                  const settings::ReaderLimits& limits = {},
                                  const std::stop_token& stop = {},
                                  const settings::Translations& translations = {},
                                  const content::Arrangement& arrangement = {}) {
  auto shelf = content::check_shelf(path, limits, languages, stop, translations, arrangement);
  report.vessels += static_cast<int>(shelf.ids.size());
  for (const fs::path& file : shelf.files) look(report, file);
  if (shelf.ids.empty() && shelf.problems.empty() && !stop.stop_requested())
    shelf.problems.push_back(
        shelf.hidden.empty()
            ? Problem{path.string(), "There is no vessel here.",
                      "Name a shelf, a vessel, an exhibit or one of their files."}
            : Problem{path.string(), "Every vessel of this shelf is hidden or unfinished.",
                      "Finish one, or take one out of `hidden` in the exhibit's file."});
  note(report, shelf.keys_checked, std::move(shelf.problems));
  report.notes.insert(report.notes.end(), shelf.notes.begin(), shelf.notes.end());
  return shelf;
}

void check_whole_exhibit(CheckReport& report, const fs::path& file,
                         const std::stop_token& stop = {}) {
  report.whole = true;
  const fs::path languages = files::language_folder(file);
  auto read = settings::read_exhibit(file, languages);
  settings::Exhibit exhibit = read.exhibit;
  exhibit.translations = content::read_translations(languages, exhibit.languages);
  content::KnownIds known;
  add(report, file, read.keys_checked, std::move(read.problems));
  std::error_code ignored;
  if (fs::is_regular_file(exhibit.rubric_file, ignored)) look(report, exhibit.rubric_file);
  // read_exhibit has reported missing files; check the existing ones.
  std::set<fs::path> scenes{exhibit.scene};
  for (const auto& [vessel, scene] : exhibit.vessel_scenes) scenes.insert(scene);
  if (exhibit.built_scene) scenes.insert(*exhibit.built_scene);
  for (const fs::path& scene : scenes)
    if (fs::is_regular_file(scene, ignored)) check_scene(report, scene);
  if (fs::is_regular_file(exhibit.glazes, ignored))
    known["glaze"] = check_glazes(report, exhibit.glazes, exhibit.languages, exhibit.translations);
  std::vector<std::string> ways;
  if (exhibit.ways) {
    WaysRead read_all = read_ways(*exhibit.ways);
    for (const fs::path& way : read_all.files) look(report, way);
    // One with a mistake is told of itself; that a vessel names it is no other mistake.
    for (const fs::path& way : read_all.files) ways.push_back(way.stem().string());
    if (ways.empty() && exhibit.decorate) note(report, 0, {no_ways(file, *exhibit.ways)});
    note(report, read_all.keys_checked, std::move(read_all.problems));
  }
  check_names(report, content::names_file(file), exhibit.languages);
  for (const auto& lesson : {exhibit.lesson, exhibit.build_lesson})
    if (lesson)
      for (std::string& id : check_lesson(report, *lesson, exhibit.languages, exhibit.translations))
        known["lesson"].push_back(std::move(id));
  for (const device::KindInfo& kind : device::device_kinds())
    if (fs::is_regular_file(device_file(exhibit, kind.kind), ignored)) {
      auto device = device_of(exhibit, kind.kind);
      add(report, device_file(exhibit, kind.kind), device.keys_checked, std::move(device.problems));
    }
  std::vector<std::string> shelf;  // what visitors see
  if (fs::is_directory(exhibit.shelf, ignored)) {
    const content::ShelfCheck check =
        check_vessels(report, exhibit.shelf, exhibit.languages, exhibit.reader, stop,
                      exhibit.translations, {exhibit.order, exhibit.hidden});
    shelf = check.ids;
    std::vector<std::string> all = shelf;
    all.insert(all.end(), check.hidden.begin(), check.hidden.end());
    if (!stop.stop_requested()) {
      note(report, 0, unknown_names(exhibit, all));
      // An exhibit without ways leaves its vessels undecorated.
      if (!ways.empty()) note(report, 0, unknown_ways(exhibit.shelf, all, ways, known["glaze"]));
      known["vessel"] = std::move(all);
    }
  }
  if (exhibit.missions)
    known["mission"] =
        check_missions(report, *exhibit.missions, exhibit.languages, &exhibit, shelf);
  for (const std::string& code : exhibit.languages)
    if (const fs::path words = languages / (code + ".toml"); fs::is_regular_file(words, ignored))
      check_language(report, words, known);
}

void check_device(CheckReport& report, const fs::path& file) {
  for (const device::KindInfo& kind : device::device_kinds())
    if (kind.id == file.stem().string()) {
      auto device = device::read_device(file, device::default_def(kind.kind));
      add(report, file, device.keys_checked, std::move(device.problems));
    }
}

void check_toml(CheckReport& report, const fs::path& file,
                const std::vector<std::string>& languages) {
  switch (kind_of_toml(file)) {
    case FileKind::exhibit:
      return check_whole_exhibit(report, file);
    case FileKind::scene:
      return check_scene(report, file);
    case FileKind::device:
      return check_device(report, file);
    case FileKind::language:
      return check_language(report, file);
    case FileKind::names:
      return check_names(report, file, languages);
    case FileKind::staff_page:
      report.files.push_back(file);
      report.notes.push_back({file.string(), "These are words of the staff's page.",
                              "onggi-console says at its start what is wrong with them."});
      return;
    case FileKind::vessel:
      check_vessels(report, file.has_parent_path() ? file.parent_path() : fs::path("."), languages);
      return;
    case FileKind::glazes:
      check_glazes(report, file);
      return;
    case FileKind::lesson:
      check_lesson(report, file, languages);
      return;
    case FileKind::missions:
      check_missions(report, file, languages);
      return;
    case FileKind::drawing: {
      auto drawing = content::check_drawing(file);
      return add(report, file, drawing.keys_checked, std::move(drawing.problems));
    }
    case FileKind::decoration: {
      auto decoration = decoration::check_decoration(file);
      return add(report, file, decoration.keys_checked, std::move(decoration.problems));
    }
    case FileKind::way: {
      auto way = decoration::read_way(file, languages);
      return add(report, file, way.keys_checked, std::move(way.problems));
    }
    case FileKind::rubric: {
      auto rubric = settings::read_rubric(file);
      return add(report, file, rubric.keys_checked, std::move(rubric.problems));
    }
  }
}

/// Languages of the exhibit `config`, else of the site that contains `path`; empty if there is
/// none.
std::vector<std::string> languages_for(const fs::path& path, const std::string& config) {
  std::error_code ignored;
  fs::path file = files::site_exhibit(path);
  if (!config.empty())
    if (const auto named = files::exhibit_file(config)) file = *named;
  if (!fs::is_regular_file(file, ignored)) return {};
  return settings::read_exhibit(file).exhibit.languages;
}

std::string count(int n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

Result<CheckReport> check_but_letters(const std::string& path, const std::string& config,
                                      const std::stop_token& stop) {
  CheckReport report;
  std::error_code ignored;
  if (path.empty()) {
    const auto exhibit = files::exhibit_file(config);
    if (!exhibit) return tl::unexpected(exhibit.error());
    if (!fs::exists(*exhibit, ignored))
      return problem(exhibit->string(), "There is no such exhibit.",
                     "Name an exhibit.toml, or a folder that holds one.");
    check_whole_exhibit(report, *exhibit, stop);
    return report;
  }
  if (fs::is_directory(path, ignored)) {
    for (const fs::path& inside :
         {fs::path(path) / "exhibit.toml", fs::path(path) / "config" / "exhibit.toml"})
      if (fs::is_regular_file(inside, ignored)) {
        check_whole_exhibit(report, inside);
        return report;
      }
    check_vessels(report, path, languages_for(path, config));
    return report;
  }
  if (!fs::exists(path, ignored))
    return problem(path, "There is no file or folder with this name.",
                   "Name an exhibit, a scene, a language, glazes, a drawing, a vessel or a shelf.");
  if (fs::path(path).extension() == ".toml")
    check_toml(report, path, languages_for(path, config));
  else
    check_vessels(report, path, languages_for(path, config));
  return report;
}

}  // namespace

std::string CheckReport::summary() const {
  std::string counts = count(static_cast<int>(files.size()), "file", "files") + ", " +
                       count(keys, "key", "keys") + ", " + count(vessels, "vessel", "vessels") +
                       ", " + count(languages, "language", "languages");
  if (problems.empty()) return "All good: checked " + counts + ".";
  return count(static_cast<int>(problems.size()), "problem", "problems") + ": checked " + counts +
         ".";
}

Result<CheckReport> check_path(const std::string& path, const std::string& config,
                               const std::stop_token& stop) {
  auto report = check_but_letters(path, config, stop);
  if (!report) return report;
  LettersReport letters = check_letters(report->files, render::FontCoverage::here());
  report->notes.insert(report->notes.end(), letters.notes.begin(), letters.notes.end());
  note(*report, 0, std::move(letters.problems));
  return report;
}

}  // namespace onggi::exhibit
