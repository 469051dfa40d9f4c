#include "tests/ends/keys.h"

#include <array>
#include <optional>
#include <sstream>
#include <string>
#include <variant>

#include "engine/contact/tool.h"
#include "engine/scene/scene_def.h"
#include "kiosk/collection/settings/exhibit_settings.h"
#include "kiosk/collection/settings/mission_file.h"
#include "kiosk/collection/settings/visitor_text.h"

namespace onggi::ends {
namespace {

using files::Json;
using settings::Setting;
using settings::TextBound;

std::string written(double value) {
  std::ostringstream out;
  out.precision(9);
  out << value;
  return out.str();
}

Json key_of(const std::string& file, const std::string& table, const std::string& key) {
  return Json::object({{"file", file}, {"table", table}, {"key", key}});
}

void add(Json& all, const std::string& file, const std::string& table, const std::string& key,
         const std::string& least, const std::string& most) {
  Json one = key_of(file, table, key);
  one["ends"] = Json::list({least, most});
  all.push_back(one);
}

void add(Json& all, const std::string& file, const std::string& key, TextBound bound) {
  Json one = key_of(file, "", key);
  one["letters"] = bound.letters;
  one["wide"] = bound.wide;
  one["lines"] = bound.lines;
  all.push_back(one);
}

void add_exhibit(Json& all) {
  for (const Setting& setting : settings::exhibit_settings()) {
    const std::string table(setting.table), key(setting.key);
    const auto is = [&setting]<class Value>(std::optional<Value>) {
      return std::holds_alternative<settings::SettingPlace<Value>>(setting.place);
    };
    if (is(std::optional<bool>()))
      add(all, "exhibit", table, key, "false", "true");
    else if (is(std::optional<int>()) || is(std::optional<double>()))
      add(all, "exhibit", table, key, written(setting.least), written(setting.most));
  }
  // The rest has no range: paths, and lists and texts with readers of their own.
  std::string scripts = "[\"follow\"";
  for (int n = 1; n < 32; ++n) scripts += n % 2 == 0 ? ", \"follow\"" : ", \"collapse\"";
  add(all, "exhibit", "attract", "scripts", R"(["follow"])", scripts + "]");
  add(all, "exhibit", "phone", "address", R"("http://1")",
      "\"http://" + std::string(93, 'W') + "\"");
  all.push_back([] {
    Json one = key_of("exhibit", "", "credit");
    one["letters"] = settings::bounds::kExhibitCredit.letters;
    one["wide"] = one["lines"] = false;
    return one;
  }());
  all.push_back([] {
    Json one = key_of("exhibit", "title", "en");
    one["letters"] = settings::bounds::kExhibitTitle.letters;
    one["wide"] = one["lines"] = false;
    return one;
  }());
}

template <class Def>
void add_fields(Json& all, const std::string& file) {
  each_field<Def>([&](const auto& field) {
    if constexpr (std::is_same_v<Def, PrintsDef>)
      if (field.key == std::string("paddle"))
        return add(all, file, Def::kName, field.key, R"("plain")", R"("grid")");
    if constexpr (requires(Def def) {
                    requires std::is_same_v<decltype(def.*(field.value)), bool&>;
                  })
      add(all, file, Def::kName, field.key, "false", "true");
    else
      add(all, file, Def::kName, field.key, written(field.least), written(field.most));
  });
}

void add_scene(Json& all) {
  SceneDef def;
  each_part(def, [&]<class Part>(const Part&) { add_fields<Part>(all, "scene"); });
  each_effect(def, [&]<class Def>(const std::optional<Def>&) { add_fields<Def>(all, "scene"); });
  for (const SceneTool& tool : def.tools) {
    const ToolShape& shape = *find_tool_shape(tool.name);
    for (const auto& [key, size] : {std::pair{"radius", &ToolSize::radius},
                                    {"length", &ToolSize::length},
                                    {"thickness", &ToolSize::thickness}})
      if (shape.usual.*size > 0.0)
        add(all, "scene", tool.name, key, written(shape.least.*size), written(shape.most.*size));
  }
  add_fields<PaperDef>(all, "paper");
}

void add_rubric(Json& all) {
  for (const char* part : {"outline", "volume", "belly", "mouth", "neck", "foot", "curvature",
                           "opening", "wall", "height"}) {
    const double most = part == std::string("curvature") ? 180.0 : 1.0;
    add(all, "rubric", part, "share", "0", "1");
    add(all, "rubric", part, "half", written(0.001 * most), written(most));
  }
  add(all, "rubric", "worst", "limit", "0.005", "1");
  add(all, "rubric", "worst", "points", "1", "99.9");
  add(all, "rubric", "", "size_counts", "false", "true");
  add(all, "rubric", "", "stars", "[0.1, 0.2, 0.3, 0.4]", "[99.7, 99.8, 99.9, 100]");
}

void add_content(Json& all) {
  namespace bounds = settings::bounds;
  add(all, "pack", "", "true_height_mm", "5", "5000");
  add(all, "pack", "", "true_diameter_mm", "5", "5000");
  add(all, "pack", "", "color", "[0, 0, 0]", "[1, 1, 1]");
  add(all, "pack", "institution", bounds::kInstitution);
  add(all, "pack", "accession", bounds::kAccession);
  add(all, "pack", "source", bounds::kSource);
  add(all, "pack", "credit", bounds::kCredit);
  add(all, "pack", "licence", bounds::kLicence);
  add(all, "label", "title", bounds::kTitle);
  add(all, "label", "what", bounds::kWhat);
  add(all, "label", "culture", bounds::kCulture);
  add(all, "label", "date", bounds::kDate);
  add(all, "label", "made", bounds::kMade);
  add(all, "label", "text", bounds::kText);
  add(all, "label", "credit", bounds::kLabelCredit);
  add(all, "glaze", "name", bounds::kGlazeName);
  add(all, "glaze", "about", bounds::kGlazeAbout);
  for (const char* share : {"slip_cover", "brushed", "pooling", "gloss", "band_height"})
    add(all, "glaze", "", share, "0", "1");
  add(all, "glaze", "", "band_width", "0", "0.2");
  add(all, "step", "words", bounds::kStepWords);
  add(all, "step", "", "after", "3", "120");
  add(all, "mission", "title", bounds::kMissionTitle);
  add(all, "mission", "about", bounds::kMissionAbout);
  add(all, "mission", "", "litres", written(settings::kLeastLitres),
      written(settings::kMostLitres));
  add(all, "mission", "", "height_mm", "[40, 40]", "[200, 200]");
  add(all, "mission", "", "mouth_mm", "[40, 40]", "[220, 220]");
  add(all, "way", "name", bounds::kWayName);
  add(all, "way", "about", bounds::kWayAbout);
  add(all, "way", "how", bounds::kToolHow);
  add(all, "way", "did", bounds::kToolHow);
}

}  // namespace

Json every_key() {
  Json all = Json::list();
  add_exhibit(all);
  add_scene(all);
  add_rubric(all);
  add_content(all);
  return all;
}

}  // namespace onggi::ends
