#include "kiosk/collection/decoration/decoration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "kiosk/collection/settings/color_in.h"

namespace onggi::decoration {

namespace {

using Table = toml::TomlReader::Table;

constexpr std::size_t kMostSteps = 200;
constexpr std::array<std::pair<std::string_view, Step::Kind>, 8> kKinds{
    {{"coat", Step::coat},
     {"band", Step::band},
     {"paint", Step::paint},
     {"cut", Step::cut},
     {"wipe", Step::wipe},
     {"resist", Step::resist},
     {"smoke", Step::smoke},
     {"burnish", Step::burnish}}};
constexpr const char* kKindsInWords =
    "\"coat\", \"band\", \"paint\", \"cut\", \"wipe\", \"resist\", \"smoke\" or \"burnish\"";

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
    const auto found = std::ranges::find(kKinds, kind, [](const auto& one) { return one.first; });
    if (found == kKinds.end()) {
      table.complain("do", "do is \"" + kind + "\", which nobody does here.",
                     std::string("Write ") + kKindsInWords + ".");
      return step;
    }
    step.kind = found->second;
    if (table.text("side", side) && side != "outside" && side != "inside")
      table.complain("side", "side is \"" + side + "\".", "Write \"outside\" or \"inside\".");
    step.inside = side == "inside";
    table.text("says", step.says);
    read_place(table, step);
    if (step.kind == Step::coat || step.kind == Step::band || step.kind == Step::paint)
      read_coat(table, step);
    if (step.kind == Step::paint) table.require("motif", "Name a table [motif.ID] of this file.");
    if (step.kind == Step::paint || step.kind == Step::cut || step.kind == Step::wipe ||
        step.kind == Step::resist)
      read_motif(table, step);
    read_length(table, "width_mm", 1e-3, 0.2, 200.0, step.width);
    table.finish();
    return step;
  }

 private:
  void read_place(Table& table, Step& step) const {
    switch (step.kind) {
      case Step::coat:
      case Step::burnish:
        table.number("from", step.from, 0.0, 1.0);
        table.number("to", step.to, 0.0, 1.0);
        if (step.from >= step.to)
          table.complain("to", "the zone ends where it begins, or below.",
                         "Write from less than to: shares of the outline, 0 at the foot.");
        break;
      case Step::smoke:
        table.require("from", "Say from where on it is black: a share of the outline.");
        table.number("from", step.from, 0.0, 1.0);
        read_length(table, "soft_mm", 1e-3, 1.0, 50.0, step.soft);
        read_length(table, "wander_mm", 1e-3, 0.0, 50.0, step.wander);
        break;
      default:
        table.require("at", "Say how high: a share of the outline, 0 at the foot, 1 at the lip.");
        table.number("at", step.at, 0.0, 1.0);
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
    read_length(table, "thickness_um", 1e-6, 10.0, 1000.0, step.thickness);
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
    table.integer("repeat", step.repeat, 1, 1680);
    table.number("turn", step.turn, 0.0, 1.0);
    if (step.kind != Step::cut) return;
    read_length(table, "depth_mm", 1e-3, 0.05, 3.0, step.depth);
    table.boolean("sunk", step.sunk);
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
    root.complain("", "there are " + std::to_string(out.steps.size()) + " steps, but at most 200.",
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
