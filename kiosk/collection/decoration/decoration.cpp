#include "kiosk/collection/decoration/decoration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "kiosk/collection/settings/color_in.h"
#include "kiosk/collection/settings/list_file.h"

namespace onggi::decoration {

namespace {

using Table = toml::TomlReader::Table;

constexpr const char* kKindsInWords =
    "\"coat\", \"band\", \"paint\", \"cut\", \"wipe\", \"resist\", \"smoke\", \"burnish\", "
    "\"scrape\", \"stamp\" or \"coil\"";

std::vector<Pigment> read_pigments(Table& root) {
  std::vector<Pigment> out;
  Table pigments = root.child("pigment");
  for (const std::string& id : pigments.keys()) {
    Table table = pigments.child(id);
    Pigment pigment;
    pigment.id = id;
    table.require("color", "Write its colour after the fire: color = \"#2E4A86\".");
    settings::read_color(table, "color", pigment.color);
    read_length(table, "hides_um", 1e-6, 1.0, 1000.0, pigment.hides);
    table.finish();
    out.push_back(std::move(pigment));
  }
  // A cell of the surface has four bits for it.
  if (out.size() > 16)
    root.complain("pigment",
                  "there are " + std::to_string(out.size()) + " pigments, but at most 16.",
                  "Use one pigment where two look alike.");
  return out;
}

std::map<std::string, Motif> read_motifs(Table& root) {
  std::map<std::string, Motif> out;
  Table motifs = root.child("motif");
  for (const std::string& id : motifs.keys()) {
    Table table = motifs.child(id);
    out[id] = read_motif(table, id);
    table.finish();
  }
  return out;
}

class StepReader {
 public:
  StepReader(const Decoration& decoration, const std::map<std::string, Motif>& motifs)
      : decoration_(decoration), motifs_(motifs) {}

  Step read(Table& table) const {
    Step step;
    table.require("do", std::string("Say what was done: do = ") + kKindsInWords + ".");
    std::string kind, side;
    if (!table.text("do", kind)) return step;
    const auto found = std::ranges::find(kKindNames, kind);
    if (found == kKindNames.end()) {
      table.complain("do", "do is \"" + kind + "\", which nobody does here.",
                     std::string("Write ") + kKindsInWords + ".");
      return step;
    }
    step.kind = static_cast<Step::Kind>(found - kKindNames.begin());
    if (table.text("side", side) && side != "outside" && side != "inside")
      table.complain("side", "side is \"" + side + "\".", "Write \"outside\" or \"inside\".");
    step.inside = side == "inside";
    table.text("says", step.says);
    read_place(table, step);
    if (step.kind == Step::coat || step.kind == Step::band || step.kind == Step::paint)
      read_coat(table, step);
    if (step.kind == Step::paint || step.kind == Step::stamp)
      table.require("motif", "Name a table [motif.ID] of this file.");
    if (takes_motif(step)) read_motif(table, step);
    if (step.kind == Step::cut) read_cut(table, step);
    if (step.kind == Step::stamp) read_stamp(table, step);
    if (step.kind == Step::coil) {
      read_length(table, "height_mm", 1e-3, 0.3, 20.0, step.height);
      table.integer("marks", step.marks, 8, 120);
    }
    read_length(table, "width_mm", 1e-3, 0.2, 1000.0, step.width);
    table.finish();
    return step;
  }

 private:
  void read_place(Table& table, Step& step) const {
    switch (step.kind) {
      case Step::burnish:
        step.zone = !table.has("at");
        return step.zone ? read_zone(table, step) : read_at(table, step);
      case Step::coat:
        return read_zone(table, step);
      case Step::smoke:
        table.require("from", "Say from where on it is black: a share of the outline.");
        table.number("from", step.from, 0.0, 1.0);
        read_length(table, "soft_mm", 1e-3, 1.0, 1000.0, step.soft);
        read_length(table, "wander_mm", 1e-3, 0.0, 1000.0, step.wander);
        table.integer("seed", step.seed, 0, 1000000);
        return;
      default:
        return read_at(table, step);
    }
  }

  static void read_zone(Table& table, Step& step) {
    table.number("from", step.from, 0.0, 1.0);
    table.number("to", step.to, 0.0, 1.0);
    if (step.from >= step.to)
      table.complain("to", "the zone ends where it begins, or below.",
                     "Write from less than to: shares of the outline, 0 at the foot.");
  }

  static void read_at(Table& table, Step& step) {
    table.require("at", "Say how high: a share of the outline, 0 at the foot, 1 at the lip.");
    table.number("at", step.at, 0.0, 1.0);
  }

  /// A ring, unless it has a motif.
  static bool takes_motif(const Step& step) {
    switch (step.kind) {
      case Step::coat:
      case Step::band:
      case Step::smoke:
      case Step::coil:
        return false;
      default:
        return !step.zone;
    }
  }

  void read_coat(Table& table, Step& step) const {
    table.require("with", "Name a pigment, or \"glaze\".");
    std::string with;
    if (table.text("with", with)) {
      const auto& all = decoration_.pigments;
      const auto found = std::ranges::find(all, with, &Pigment::id);
      const bool glaze = with == "glaze" && step.kind == Step::coat;
      if (found == all.end() && !glaze)
        table.complain("with", "there is no pigment \"" + with + "\".",
                       "Name a table [pigment.ID] of this file, or, for a coat, \"glaze\".");
      step.pigment = glaze ? kGlaze : static_cast<int>(found - all.begin());
    }
    if (step.kind == Step::coat) {
      read_length(table, "thickness_um", 1e-6, 10.0, 1000.0, step.thickness);
      return;
    }
    read_length(table, "thickness_um", 1e-6, 2.0, 2000.0, step.thickness);
    table.number("fill", step.fill, 0.0, 1.0);
    if (step.kind == Step::paint) read_length(table, "load_mm", 1e-3, 10.0, 10000.0, step.load);
  }

  void read_motif(Table& table, Step& step) const {
    std::string id;
    if (table.text("motif", id)) {
      if (const auto found = motifs_.find(id); found != motifs_.end())
        step.motif = found->second;
      else
        table.complain("motif", "there is no motif \"" + id + "\".",
                       "Name a table [motif.ID] of this file.");
    }
    read_length(table, "size_mm", 1e-3, 1.0, 1000.0, step.size);
    table.integer("repeat", step.repeat, 1, surface::kSectors);
    if (step.repeat > 0 && surface::kSectors % step.repeat != 0)
      table.complain(
          "repeat",
          "repeat is " + std::to_string(step.repeat) + ", which does not divide the pot evenly.",
          "Choose 2 to 8, 10, 12, 14, 15 or 16.");
    table.number("turn", step.turn, 0.0, 1.0);
  }

  static void read_cut(Table& table, Step& step) {
    read_length(table, "depth_mm", 1e-3, 0.05, 20.0, step.depth);
    settings::read_one_of(table, "section", "section", kSectionNames, step.section);
    if (bool sunk = false; table.boolean("sunk", sunk) && sunk) {
      if (table.has("section"))
        table.complain("sunk", "the cut has a section, too.", "Remove sunk, or section.");
      step.section = surface::CutDef::sunk;
    }
    table.integer("teeth", step.teeth, 1, 9);
    read_length(table, "spacing_mm", 1e-3, 0.5, 100.0, step.spacing);
  }

  static void read_stamp(Table& table, Step& step) {
    read_length(table, "depth_mm", 1e-3, 0.05, 20.0, step.depth);
    if (!step.motif.lines.empty() && step.motif.fills.empty())
      table.complain("motif", "the motif has no area, so a stamp of it presses nothing.",
                     "Draw an area: [[motif.ID.fill]].");
  }

  const Decoration& decoration_;
  const std::map<std::string, Motif>& motifs_;
};

}  // namespace

DecorationRead check_decoration(const std::filesystem::path& toml) {
  DecorationRead read;
  Decoration& out = read.decoration;
  toml::TomlReader reader(toml);
  Table root = reader.root();
  read_source(root, "sources", "Say where it is published how it was decorated.", out.sources);
  read_source(root, "simplified", "Say what is simplified; \"nothing\" if so.", out.simplified);
  root.require("body", "Write the colour of the fired clay: body = \"#E7E6DE\".");
  root.text("checked_by", out.checked_by);
  settings::read_color(root, "body", out.body);
  out.glaze = {1.0f, 1.0f, 1.0f};
  settings::read_color(root, "glaze", out.glaze);
  out.pigments = read_pigments(root);
  const std::map<std::string, Motif> motifs = read_motifs(root);
  const StepReader steps(out, motifs);
  for (Table& table : root.children("step")) out.steps.push_back(steps.read(table));
  if (out.steps.size() > kMostSteps)
    root.complain("",
                  "there are " + std::to_string(out.steps.size()) + " steps, but at most " +
                      std::to_string(kMostSteps) + ".",
                  "Draw what is repeated as one motif.");
  root.child("pigment").finish();
  root.child("motif").finish();
  root.finish();
  read.problems = reader.problems();
  read.keys_checked = reader.keys_checked();
  return read;
}

Result<Decoration> read_decoration(const std::filesystem::path& toml) {
  DecorationRead read = check_decoration(toml);
  if (!read.problems.empty()) return tl::unexpected<Problem>(read.problems.front());
  return std::move(read.decoration);
}

}  // namespace onggi::decoration
