#include "kiosk/collection/content/glaze.h"

#include <algorithm>
#include <cmath>

#include "kiosk/collection/content/content_fields.h"
#include "kiosk/collection/settings/color_in.h"
#include "kiosk/collection/settings/list_file.h"
#include "kiosk/collection/settings/text_in.h"
#include "kiosk/collection/settings/visitor_text.h"
#include "kiosk/ground/fields/field_reader.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

namespace {

using Table = toml::TomlReader::Table;

void read_share(Table& table, const std::string& key, float& out) {
  double value = static_cast<double>(out);
  if (fields::read_number(table, fields::field_at(glaze_fields(), "glaze", key), value))
    out = static_cast<float>(value);
}

/// Texts by language; if `needed`, all of `languages` are required.
bool read_words(Table& glaze, const std::string& key, settings::TextBound most,
                const std::vector<std::string>& languages, bool needed,
                const settings::Translations& translations, const std::string& id,
                std::map<std::string, std::string>& out) {
  Table words = glaze.child(key);
  for (const std::string& code : words.keys()) {
    std::string text;
    if (settings::read_visitor_text(words, code, key + "." + code, most, text))
      out[code] = std::move(text);
  }
  translations.put("glaze", id, key, out);
  for (const std::string& code : languages)
    if (needed && !out.contains(code))
      glaze.complain(words.present() ? key : "",
                     "The glaze has no " + key + " in the language \"" + code + "\".",
                     "Write " + key + " = { " + code +
                         " = \"...\" }, one entry for each language, or [glaze." + id +
                         "] in content/languages/" + code + ".toml.");
  words.finish();
  return !out.empty();
}

/// False if the glaze cannot be shown.
bool read_glaze(Table& table, const std::vector<std::string>& languages,
                const settings::Translations& translations, Glaze& glaze) {
  bool good = settings::read_id(table, glaze.id, "celadon", "white_porcelain");
  if (languages.empty()) table.require("name", "Write name = { en = \"Celadon\" }.");
  good = read_words(table, "name", settings::bounds::kGlazeName, languages, true, translations,
                    glaze.id, glaze.name) &&
         good;
  read_words(table, "about", settings::bounds::kGlazeAbout, languages, false, translations,
             glaze.id, glaze.about);
  GlazeLook& look = glaze.look;
  for (const char* key : {"body", "glass"})
    table.require(key, std::string("Write a colour: ") + key + " = \"#9DB5A0\".");
  good = settings::read_color(table, "body", look.body) && good;
  good = settings::read_color(table, "glass", look.glass) && good;
  // Slip and band exist if their colour is written.
  if (!settings::read_color(table, "slip", look.slip)) look.slip_cover = 0.0f;
  read_share(table, "slip_cover", look.slip_cover);
  read_share(table, "brushed", look.brushed);
  read_share(table, "pooling", look.pooling);
  read_share(table, "gloss", look.gloss);
  if (settings::read_color(table, "band", look.band))
    look.band_height = 0.8f, look.band_width = 0.02f;
  read_share(table, "band_height", look.band_height);
  read_share(table, "band_width", look.band_width);
  table.finish();
  return good;
}

}  // namespace

const std::string& Glaze::name_in(const std::string& language) const {
  return settings::text_in(name, language);
}
const std::string& Glaze::about_in(const std::string& language) const {
  return settings::text_in(about, language);
}

GlazesRead read_glazes(const std::filesystem::path& file, const std::vector<std::string>& languages,
                       const settings::Translations& translations) {
  GlazesRead read;
  toml::TomlReader reader(file);
  read.glazes = settings::read_list<Glaze>(
      reader, "glaze", kMostGlazes, "Remove some: the screen has no room for more.",
      [&](Table& table, Glaze& glaze) {
        return read_glaze(table, languages, translations, glaze);
      });
  read.problems = reader.problems();
  if (reader.ok() && read.problems.empty() && read.glazes.empty())
    read.problems.push_back({file.string(), "The file contains no glaze.",
                             "Write a [[glaze]] with id, name, body and glass."});
  read.keys_checked = reader.keys_checked();
  return read;
}

LinearColor swatch(const GlazeLook& look) {
  LinearColor out{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float cover = look.slip_cover * (1.0f - 0.3f * look.brushed);
    const float under = look.body[k] + (look.slip[k] - look.body[k]) * cover;
    out[k] = 0.95f * under * std::pow(std::max(look.glass[k], 1e-4f), 0.6f);
  }
  return out;
}

}  // namespace onggi::content
