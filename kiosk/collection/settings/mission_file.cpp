#include "kiosk/collection/settings/mission_file.h"

#include <algorithm>
#include <string>

#include "engine/base/nearest_name.h"
#include "kiosk/collection/settings/list_file.h"
#include "kiosk/collection/settings/mission_fields.h"
#include "kiosk/collection/settings/text_in.h"
#include "kiosk/collection/settings/visitor_text.h"
#include "kiosk/ground/fields/field_reader.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::settings {

namespace {

using MissionTable = toml::TomlReader::Table;

/// False if no visitor could read what the mission is.
bool read_said(MissionTable& mission, const std::string& key, TextBound most,
               const std::vector<std::string>& languages, const Translations& translations,
               const std::string& id, std::map<std::string, std::string>& out) {
  MissionTable words = mission.child(key);
  for (const std::string& code : words.keys()) {
    std::string text;
    if (read_visitor_text(words, code, key + "." + code, most, text)) out[code] = std::move(text);
  }
  translations.put("mission", id, key, out);
  for (const std::string& code : languages)
    if (!out.contains(code) && !words.has(code))
      mission.complain(words.present() ? key : "",
                       "The mission has no " + key + " in the language \"" + code + "\".",
                       "Write " + key + " = { " + code +
                           " = \"...\" }, one entry for each language, or [mission." + id +
                           "] in content/languages/" + code +
                           ".toml. Until then visitors see it in "
                           "English, or in the first language that has it.");
  words.finish();
  if (out.empty() && languages.empty())
    mission.complain(words.present() ? key : "", "The mission has no " + key + ".",
                     "Write " + key + " = { en = \"...\" }.");
  return !out.empty();
}

bool read_kind(MissionTable& mission, Mission::Kind& kind) {
  mission.require("kind", "Write kind = \"...\", one of " + joined(kMissionKinds) + ".");
  return read_one_of(mission, "kind", "kind of mission", kMissionKinds, kind);
}

bool is_on_shelf(MissionTable& mission, const std::string& key, std::size_t index, bool of_list,
                 const std::string& id, const std::vector<std::string>& shelf) {
  if (shelf.empty() || std::ranges::find(shelf, id) != shelf.end()) return true;
  const std::string nearest = nearest_name(id, shelf);
  const std::string what = "There is no vessel \"" + id + "\" on the shelf.";
  const std::string remedy = nearest.empty()
                                 ? "Write the name of its folder on the shelf, or remove it."
                                 : "Did you mean \"" + nearest + "\"?";
  of_list ? mission.complain_at(key, index, what, remedy) : mission.complain(key, what, remedy);
  return false;
}

bool read_today(MissionTable& mission, const std::vector<std::string>& shelf, Mission& out) {
  if (!mission.texts("vessels", out.vessels)) return !mission.has("vessels");
  if (out.vessels.empty())
    mission.complain("vessels", "vessels is empty.",
                     "Name vessels on the shelf, or remove the key to use all of them.");
  bool good = !out.vessels.empty();
  for (std::size_t n = 0; n < out.vessels.size(); ++n)
    good = is_on_shelf(mission, "vessels", n, true, out.vessels[n], shelf) && good;
  return good;
}

bool read_vessel(MissionTable& mission, const std::vector<std::string>& shelf, std::string& out) {
  if (!mission.text("vessel", out)) return !mission.has("vessel");
  return is_on_shelf(mission, "vessel", 0, false, out, shelf);
}

/// [from, to] in mm.
bool read_bounds(MissionTable& mission, const std::string& key,
                 std::optional<Mission::Described::Bounds>& out) {
  const fields::Field& field = fields::field_at(mission_fields(), "mission", key);
  const double low = field.least, high = field.most;
  std::vector<double> mm;
  if (!mission.numbers(key, mm)) return !mission.has(key);
  if (mm.size() != 2 || !(mm[0] <= mm[1]) || mm[0] < low || mm[1] > high) {
    const auto text = [](double x) { return std::to_string(static_cast<int>(x)); };
    mission.complain(key, key + " is not a minimum and a maximum.",
                     "Write two numbers from " + text(low) + " to " + text(high) +
                         " mm, the smaller first: " + key + " = [" + text(low) + ", " + text(high) +
                         "].");
    return false;
  }
  out = Mission::Described::Bounds{1e-3 * mm[0], 1e-3 * mm[1]};
  return true;
}

bool read_described(MissionTable& mission, Mission::Described& out) {
  mission.require("litres", "Write how much it should hold: litres = 1.0.");
  double litres = 1.0;
  bool good =
      fields::read_number(mission, fields::field_at(mission_fields(), "mission", "litres"), litres);
  out.volume = 1e-3 * litres;
  good = read_bounds(mission, "height_mm", out.height) && good;
  return read_bounds(mission, "mouth_mm", out.mouth) && good;
}

bool read_mission(MissionTable& table, const std::vector<std::string>& languages,
                  const std::vector<std::string>& shelf, const Translations& translations,
                  Mission& mission) {
  bool good = read_id(table, mission.id, "litre_jar");
  if (good && std::ranges::find(shelf, mission.id) != shelf.end()) {
    table.complain("id", "A vessel on the shelf already has the name \"" + mission.id + "\".",
                   "Give the mission another id: keepsakes carry this name.");
    good = false;
  }
  table.boolean("on", mission.on);
  good = read_said(table, "title", bounds::kMissionTitle, languages, translations, mission.id,
                   mission.title) &&
         good;
  good = read_said(table, "about", bounds::kMissionAbout, languages, translations, mission.id,
                   mission.about) &&
         good;
  if (!read_kind(table, mission.kind)) return false;  // the other keys depend on the kind
  // A mission that is off may name vessels that are no longer on the shelf.
  const std::vector<std::string> there = mission.on ? shelf : std::vector<std::string>();
  switch (mission.kind) {
    case Mission::Kind::today:
      good = read_today(table, there, mission) && good;
      break;
    case Mission::Kind::describe:
      good = read_described(table, mission.wanted) && good;
      break;
    case Mission::Kind::eyes_closed:
      good = read_vessel(table, there, mission.vessel) && good;
      break;
    case Mission::Kind::two_hands:
      good = read_vessel(table, there, mission.vessel) && good;
      good = (read_one_of(table, "second", "second hand", kSecondHands, mission.second) ||
              !table.has("second")) &&
             good;
      break;
  }
  table.finish();
  return good;
}

}  // namespace

const std::string& Mission::title_in(const std::string& language) const {
  return text_in(title, language);
}
const std::string& Mission::about_in(const std::string& language) const {
  return text_in(about, language);
}

MissionsRead read_missions(const std::filesystem::path& file,
                           const std::vector<std::string>& languages,
                           const std::vector<std::string>& shelf,
                           const Translations& translations) {
  MissionsRead read;
  toml::TomlReader reader(file);
  read.missions = read_list<Mission>(
      reader, "mission", kMostMissions, "Remove some: visitors see the shelf after them.",
      [&](MissionTable& table, Mission& mission) {
        return read_mission(table, languages, shelf, translations, mission);
      });
  read.problems = reader.problems();
  read.keys_checked = reader.keys_checked();
  return read;
}

}  // namespace onggi::settings
