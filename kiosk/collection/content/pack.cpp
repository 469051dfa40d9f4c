#include "kiosk/collection/content/pack.h"

#include "engine/base/nearest_name.h"
#include "engine/effects/prints.h"
#include "kiosk/collection/content/address.h"
#include "kiosk/collection/content/content_fields.h"
#include "kiosk/collection/content/pack_advice.h"
#include "kiosk/collection/settings/visitor_text.h"
#include "kiosk/collection/textures/srgb.h"
#include "kiosk/ground/fields/field_reader.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

namespace {

constexpr const char* kUnfinished = "unfinished";

float linear(double srgb) { return static_cast<float>(textures::light_of_srgb(srgb)); }

void read_color(toml::TomlReader::Table& root, Pack& pack) {
  std::vector<double> values;
  if (!root.numbers("color", values)) return;
  bool good = values.size() == 3;
  for (const double v : values) good = good && v >= 0.0 && v <= 1.0;
  if (!good) {
    root.complain("color", "color is not three numbers from 0 to 1.",
                  "Write red, green and blue as on screen: color = [0.62, 0.44, 0.31].");
    return;
  }
  pack.color = {linear(values[0]), linear(values[1]), linear(values[2])};
}

void read_mesh_terms(toml::TomlReader::Table& root, Pack& pack) {
  root.text("node", pack.node);
  std::string unit;
  if (root.text("units", unit)) {
    if (unit == "m") pack.unit = 1.0;
    if (unit == "cm") pack.unit = 0.01;
    if (unit == "mm") pack.unit = 0.001;
    if (unit == "in") pack.unit = 0.0254;
    if (pack.unit == 0.0)
      root.complain("units", "units is \"" + unit + "\", which is not a known unit of length.",
                    "Write what one unit of the mesh is: \"mm\", \"cm\", \"m\" or \"in\".");
  }
  std::string up;
  if (!root.text("up", up)) return;
  pack.up = axis_called(up);
  if (!pack.up)
    root.complain("up", "up is \"" + up + "\", which is not an axis.",
                  "Write the axis of the mesh that points to the rim: \"y\", \"z\", \"-z\" ...");
}

/// A word that is no face of a paddle is left out; the vessel stays on the shelf.
void take_paddle(toml::TomlReader::Table& root, const std::string& name, Pack& pack) {
  if (name.empty()) return;
  const auto face = find_paddle_face(name);
  if (face) {
    pack.paddle = *face;
    return;
  }
  const std::vector<std::string> all(paddle_faces().begin(), paddle_faces().end());
  const std::string nearest = nearest_name(name, all);
  root.complain("paddle", "paddle is \"" + name + "\", which is no face of a paddle.",
                (nearest.empty() ? "Write" : "Did you mean \"" + nearest + "\"? Write") +
                    " one of " + joined(all) + ", or remove the key.");
}

void read_labels(toml::TomlReader::Table& root, PackRead& read) {
  auto labels = root.child("label");
  for (const std::string& language : labels.keys()) {
    auto table = labels.child(language);
    Label label;
    table.require("title", "Give the vessel's name in this language.");
    table.text("title", label.title);
    if (table.has("title") && settings::is_blank(label.title))
      table.complain("title",
                     label.title.find_first_not_of(" \t\r\n") == std::string::npos
                         ? "the title is empty."
                         : "the title has only characters that nobody can see.",
                     "Give the vessel's name in this language.");
    table.text("what", label.what);
    table.text("culture", label.culture);
    table.text("date", label.date);
    table.text("made", label.made);
    table.text("text", label.text);
    table.text("credit", label.credit);
    table.text("address", label.address);
    table.finish();
    read.pack.labels[language] = std::move(label);
  }
  labels.finish();
}

/// Removes addresses that a phone cannot open from the label; the vessel stays on the shelf.
void keep_good_addresses(toml::TomlReader::Table& root, Pack& pack) {
  const auto keep = [](toml::TomlReader::Table& table, std::string& address) {
    const std::string fault = fault_of_address(address);
    if (!table.has("address") || fault.empty()) return;
    table.complain("address", fault,
                   "Write the web address of the museum's page on this vessel, best a short "
                   "one: address = \"https://museum.org/12.3\". Or remove the key.");
    address.clear();
  };
  keep(root, pack.address);
  auto labels = root.child("label");
  for (auto& [language, label] : pack.labels) {
    auto table = labels.child(language);
    keep(table, label.address);
  }
}

}  // namespace

std::optional<Vec3> axis_called(const std::string& name) {
  const bool back = name.size() == 2 && name[0] == '-';
  if (name.size() != 1 && !back) return std::nullopt;
  const double to = back ? -1 : 1;
  switch (name.back()) {
    case 'x':
      return Vec3{to, 0, 0};
    case 'y':
      return Vec3{0, to, 0};
    case 'z':
      return Vec3{0, 0, to};
    default:
      return std::nullopt;
  }
}

std::string Pack::credit_line() const {
  std::string out = institution;
  if (!accession.empty()) out += (out.empty() ? "" : ", ") + accession;
  if (!credit.empty()) out += (out.empty() ? "" : ". ") + credit;
  return out;
}

PackRead read_pack(const std::filesystem::path& toml, const std::vector<std::string>& languages) {
  PackRead read;
  Pack& pack = read.pack;
  toml::TomlReader reader(toml);
  auto root = reader.root();
  root.require("licence", "Say under which licence the shape is shown: licence = \"CC0-1.0\".");
  root.require("credit", "Say whom to thank: credit = \"Museum, drawn by ...\".");
  root.boolean(kUnfinished, pack.unfinished);
  root.text("drawing", pack.drawing);
  root.text("decoration", pack.decoration);
  root.text("way", pack.way);
  root.boolean("built", pack.built);
  std::string paddle;
  root.text("paddle", paddle);
  root.texts("glazes", pack.glazes);
  double mm = 0.0;
  if (fields::read_number(root, fields::field_at(vessel_fields(), "", "true_height_mm"), mm))
    pack.true_height = 0.001 * mm;
  if (fields::read_number(root, fields::field_at(vessel_fields(), "", "true_diameter_mm"), mm))
    pack.true_diameter = 0.001 * mm;
  read_mesh_terms(root, pack);
  root.text("institution", pack.institution);
  root.text("accession", pack.accession);
  root.text("source", pack.source);
  root.text("credit", pack.credit);
  root.text("licence", pack.licence);
  root.text("address", pack.address);
  // require() reports only missing keys, so report empty ones here.
  for (const auto& [key, text] : {std::pair{"licence", &pack.licence}, {"credit", &pack.credit}})
    if (root.has(key) && settings::is_blank(*text))
      root.complain(key, std::string(key) + " is empty.",
                    key == std::string("licence")
                        ? "Say under which licence the shape is shown: licence = \"CC0-1.0\"."
                        : "Say whom to thank: credit = \"Museum, drawn by ...\".");
  read_color(root, pack);
  read_labels(root, read);
  root.finish();
  for (const auto& [key, file] :
       {std::pair{"drawing", &pack.drawing}, {"decoration", &pack.decoration}})
    if (!file->empty() && *file != std::filesystem::path(*file).filename())
      root.complain(key, std::string(key) + " names a file outside the vessel's folder.",
                    std::string("Put the ") + key + " beside vessel.toml and write only its name.");
  read.problems = reader.problems();
  keep_good_addresses(root, pack);
  take_paddle(root, paddle, pack);
  ask_for_the_rest(root, pack, languages);
  fit_to_screens(root, pack);
  read.advice = reader.problems_since(read.problems);
  read.keys_checked = reader.keys_checked();
  return read;
}

bool is_unfinished(const std::filesystem::path& folder) {
  toml::TomlReader reader(folder / "vessel.toml");
  bool unfinished = false;
  reader.root().boolean(kUnfinished, unfinished);
  return unfinished;
}

}  // namespace onggi::content
