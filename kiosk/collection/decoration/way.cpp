#include "kiosk/collection/decoration/way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "kiosk/collection/decoration/figure.h"
#include "kiosk/collection/settings/color_in.h"
#include "kiosk/collection/settings/list_file.h"
#include "kiosk/collection/settings/text_by_language.h"

namespace onggi::decoration {

namespace {

using Table = toml::TomlReader::Table;
namespace bounds = settings::bounds;

enum class Law { brush, cut, scrape, wipe, dip, smoke, burnish, stamp, resist, coil };
constexpr std::array<std::string_view, 10> kLaws{"brush", "cut",     "scrape", "wipe",   "dip",
                                                 "smoke", "burnish", "stamp",  "resist", "coil"};
constexpr std::array<std::string_view, 5> kHands{"line", "figure", "ring", "all", "up"};
constexpr double kLargestStamp = 0.03;  // m
constexpr std::array<std::string_view, 5> kStates{"soft", "leather", "dry", "fired", "glazed"};
constexpr double kFar = 1.0;  // units of a figure
// Of a figure of 1 unit; a smooth line bulges between its points.
constexpr double kHigh = 0.55;
constexpr std::size_t kMostInFigure = 8 * 2000;  // of a smoothed figure
constexpr std::array<std::string_view, 3> kSections{"v", "u", "flat"};
// A square metre of brush takes some 1.2 s of a slow core. A narrow tool's way costs like a wide
// one's of 2 mm.
constexpr double kMostDrawn = 0.1, kNarrow = 0.002;  // m^2, m

/// Of all lines and outlines, in units of the figure.
double drawn_length(const Motif& motif) {
  double sum = 0.0;
  for (const auto* all : {&motif.lines, &motif.fills})
    for (const std::vector<Vec2>& points : *all)
      for (std::size_t n = 1; n < points.size(); ++n) sum += length(points[n] - points[n - 1]);
  return sum;
}

/// How a law can be led.
bool fits(Law law, WayTool::Hand hand) {
  switch (law) {
    case Law::smoke:
      return hand == WayTool::up;
    case Law::dip:
      return hand == WayTool::up || hand == WayTool::all;
    case Law::stamp:
      return hand == WayTool::figure;
    case Law::coil:
      return hand == WayTool::ring;
    case Law::resist:
      return hand != WayTool::up && hand != WayTool::all;
    default:
      return hand != WayTool::up;
  }
}

class WayReader {
 public:
  WayReader(Way& way, const std::vector<std::string>& languages)
      : way_(way), languages_(languages) {}

  void read(Table& root) {
    read_source(root, "sources", "Say where it is published how these potters worked.",
                way_.sources);
    read_source(root, "simplified", "Say what is simplified; \"nothing\" if so.", way_.simplified);
    way_.name = words(root, "name", bounds::kWayName);
    way_.about = words(root, "about", bounds::kWayAbout);
    read_pigments(root);
    read_figures(root);
    for (Table& table : root.children("tool")) read_tool(table);
    if (way_.tools.empty())
      root.complain("", "the way has no tool.", "Write a [[tool]] with id, law and hand.");
    const auto behind =
        static_cast<std::size_t>(std::ranges::count(way_.tools, true, &WayTool::more));
    if (way_.tools.size() - behind > kMostTools)
      root.complain("", "there are more than 6 tools.",
                    "Remove some, or write more = true: the screen has no room.");
    if (behind > kMostMore)
      root.complain("", "there are more than 6 tools with more = true.", "Remove some.");
    if (!way_.tools.empty() && way_.tools.front().more)
      root.complain("", "the first tool has more = true, but the screen begins with it.",
                    "Put one without it above.");
    root.finish();
  }

 private:
  Words words(Table& table, const std::string& key, settings::TextBound bound) const {
    return settings::read_by_language(table, key, bound, languages_);
  }

  void read_pigments(Table& root) {
    Table all = root.child("pigment");
    for (const std::string& id : all.keys()) {
      Table table = all.child(id);
      Palette::Coat coat;
      table.require("color", "Write its colour after the fire: color = \"#2E4A86\".");
      settings::read_color(table, "color", coat.fired);
      coat.raw = coat.fired;
      settings::read_color(table, "raw", coat.raw);
      read_length(table, "hides_um", 1e-6, 1.0, 1000.0, coat.hides);
      way_.pigments.push_back({id, words(table, "name", bounds::kWayName)});
      way_.palette.pigments.push_back(coat);
      table.finish();
    }
    if (way_.pigments.size() > surface::kPigments)
      root.complain("pigment", "there are more than 16 pigments.", "Leave some out.");
    all.finish();
  }

  void read_figures(Table& root) {
    Table all = root.child("motif");
    for (const std::string& id : all.keys()) {
      Table table = all.child(id);
      Way::Figure figure{id, read_motif(table, id), words(table, "name", bounds::kWayName)};
      areas_.push_back(table.has("fill"));
      check_figure(table, figure);
      table.finish();
      way_.figures.push_back(std::move(figure));
    }
    all.finish();
  }

  /// A figure is small, near its middle, and soon drawn.
  void check_figure(Table& table, const Way::Figure& figure) const {
    std::size_t points = 0;
    double far = 0.0, high = 0.0;
    for (const auto* ways : {&figure.motif.fills, &figure.motif.lines})
      for (const auto& way : *ways) {
        points += way.size();
        for (const Vec2& p : way) {
          far = std::max(far, std::abs(p.x));
          high = std::max(high, std::abs(p.y));
        }
      }
    const std::string remedy =
        "Draw it 1 unit high at the most, its middle at (0, 0). size_mm says how large it is.";
    if (high > kHigh)
      table.complain(
          "",
          "the figure \"" + figure.id + "\" has a point more than 0.5 above or below its middle.",
          remedy);
    else if (far > kFar)
      table.complain("",
                     "the figure \"" + figure.id + "\" has a point more than 1 beside its middle.",
                     remedy);
    if (points > kMostInFigure)
      table.complain("", "the figure \"" + figure.id + "\" has too many points.",
                     "Draw it with fewer: 2000 in all areas and lines are enough.");
  }

  /// The places of the names under `key` in `all`.
  template <class Thing>
  std::vector<int> named(Table& table, const std::string& key, const std::vector<Thing>& all,
                         const std::string& what) const {
    std::vector<std::string> ids;
    std::vector<int> out;
    if (!table.texts(key, ids)) return out;
    if (ids.empty())
      table.complain(key, "the tool names no " + what + ".",
                     "Name one of this file's: " + key + " = [\"ID\"].");
    for (std::size_t n = 0; n < ids.size(); ++n) {
      const auto found = std::ranges::find(all, ids[n], &Thing::id);
      const int place = static_cast<int>(found - all.begin());
      if (found == all.end())
        table.complain_at(key, n, "there is no " + what + " \"" + ids[n] + "\".",
                          "Name a table [" + what + ".ID] of this file.");
      else if (std::ranges::find(out, place) != out.end())
        table.complain_at(key, n, "\"" + ids[n] + "\" is named twice.", "Name it once.");
      else
        out.push_back(place);
    }
    return out;
  }

  // A tool with a mistake counts as one, too: that no tool is there, or too few, would be wrong.
  void read_tool(Table& table) {
    WayTool tool;
    read_tool(table, tool);
    way_.tools.push_back(std::move(tool));
  }

  void read_tool(Table& table, WayTool& tool) {
    Law law{};
    table.boolean("more", tool.more);
    table.require("law", "Say what it does: law = \"brush\".");
    table.require("hand", "Say how it is led: hand = \"line\".");
    bool good = settings::read_id(table, tool.id, "band");
    good = settings::read_one_of(table, "law", "law", kLaws, law) && good;
    good = settings::read_one_of(table, "hand", "way to lead it", kHands, tool.hand) && good;
    if (good && !fits(law, tool.hand)) {
      table.complain("hand",
                     "a tool of this law cannot be led by \"" +
                         std::string(kHands[static_cast<std::size_t>(tool.hand)]) + "\".",
                     "Smoke goes up; a dip goes up or all over; a stamp makes a figure, a coil a "
                     "ring; wax is a line, a figure or a ring; the others do not go up.");
      good = false;
    }
    // What else it may have depends on these; other messages would mislead.
    if (!good) return;
    if (tool.hand == WayTool::figure) read_figure(table, tool);
    tool.law = read_law(table, law, tool);
    if (tool.hand == WayTool::figure) check_drawn(table, tool);
    if (std::string needs; table.text("needs", needs)) {
      const auto found = std::ranges::find(way_.tools, needs, &WayTool::id);
      if (found == way_.tools.end())
        table.complain("needs", "no tool before this one is called \"" + needs + "\".",
                       "Name a tool that stands above it, or remove the line.");
      else
        tool.needs = static_cast<int>(found - way_.tools.begin());
    }
    if (WayTool::State state{};
        table.has("state") && settings::read_one_of(table, "state", "state", kStates, state))
      tool.state = state;
    const bool comes_back = tool.hand == WayTool::line || tool.hand == WayTool::figure;
    if (table.integer("repeats", tool.repeats, 5, 12)) {
      if (!comes_back)
        table.complain("repeats", "repeats has no use here: only a line or a figure comes back.",
                       "Remove it.");
      else if (std::ranges::find(kRepeats, tool.repeats) == std::end(kRepeats))
        table.complain("repeats", "repeats is not 5, 8, 10 or 12.", "Write 5, 8, 10 or 12.");
    }
    tool.name = words(table, "name", bounds::kWayName);
    tool.how = words(table, "how", bounds::kToolHow);
    tool.did = words(table, "did", bounds::kToolHow);
    if (std::ranges::find(way_.tools, tool.id, &WayTool::id) != way_.tools.end())
      table.complain("id", "there are two tools \"" + tool.id + "\".",
                     "Give the second another id.");
    table.finish();
  }

  void read_figure(Table& table, WayTool& tool) const {
    table.require("motifs", "Name the figures: motifs = [\"leaf\"].");
    tool.motifs = named(table, "motifs", way_.figures, "motif");
    if (tool.motifs.size() > kMostFigures)
      table.complain("motifs", "a tool has more than 5 figures.", "Remove some.");
    read_length(table, "size_mm", 1e-3, 5.0, 100.0, tool.size);
  }

  /// The pigments of a tool that lays slip. `needed`: it lays nothing else.
  void read_slip(Table& table, WayTool& tool, bool needed) const {
    if (needed) table.require("with", "Name the pigments: with = [\"white\"].");
    tool.pigments = named(table, "with", way_.pigments, "pigment");
  }

  /// What a touch draws at once, all round the pot, must not hold up the screen.
  void check_drawn(Table& table, const WayTool& tool) const {
    const double width = std::visit(
        [](const auto& law) {
          if constexpr (requires { law.width; }) return law.width;
          return 0.0;
        },
        tool.law);
    for (const int figure : tool.motifs) {
      const Way::Figure& drawn = way_.figures[static_cast<std::size_t>(figure)];
      const double area =
          std::end(kRepeats)[-1] * tool.size * drawn_length(drawn.motif) * std::max(width, kNarrow);
      if (area > kMostDrawn)
        return table.complain("motifs",
                              "the lines of \"" + drawn.id +
                                  "\" are so long, and the tool so wide, that 12 of it would hold "
                                  "up the screen.",
                              "Draw it with shorter lines, or make size_mm or width_mm less.");
    }
  }

  surface::Tool read_law(Table& table, Law law, WayTool& tool) const {
    switch (law) {
      case Law::brush: {
        surface::BrushDef def;
        read_slip(table, tool, true);
        if (!tool.pigments.empty()) def.pigment = tool.pigments.front();
        read_length(table, "width_mm", 1e-3, 0.5, 40.0, def.width);
        read_length(table, "thickness_um", 1e-6, 2.0, 2000.0, def.thickness);
        table.number("fill", def.fill, 0.0, 1.0);
        def.reach = kEndlessWay;
        // Each touch is a freshly dipped brush.
        if (tool.hand == WayTool::line)
          read_length(table, "load_mm", 1e-3, 10.0, 1000.0, def.reach);
        return def;
      }
      case Law::cut: {
        surface::CutDef def;
        read_length(table, "width_mm", 1e-3, 0.2, 10.0, def.width);
        read_length(table, "depth_mm", 1e-3, 0.15, 3.0, def.depth);
        settings::read_one_of(table, "section", "section", kSections, def.section);
        const bool one_tooth =
            !table.has("teeth") || (table.integer("teeth", def.teeth, 1, 9) && def.teeth == 1);
        if (read_length(table, "spacing_mm", 1e-3, 0.5, 6.0, def.spacing) && one_tooth)
          table.complain("spacing_mm", "spacing_mm has no use here: the tool has one tooth.",
                         "Remove it, or write teeth = 2 or more.");
        def.burr = 0.0;  // brushed off
        return def;
      }
      case Law::scrape: {
        surface::ScrapeDef def;
        read_length(table, "width_mm", 1e-3, 1.0, 40.0, def.width);
        return def;
      }
      case Law::wipe: {
        surface::WipeDef def;
        read_length(table, "width_mm", 1e-3, 2.0, 30.0, def.width);
        def.wet_time = 3600.0;  // the pot waits for its visitor
        return def;
      }
      case Law::dip: {
        surface::DipDef def;
        read_slip(table, tool, false);
        def.coat = tool.pigments.empty() ? surface::DipDef::kGlaze : tool.pigments.front();
        double thickness = 5e-4;
        read_length(table, "thickness_um", 1e-6, 10.0, 1000.0, thickness);
        def.seconds = 1.0, def.rate = thickness, def.drinks = 1.0;
        return def;
      }
      case Law::smoke:
        return surface::SmokeDef{};
      case Law::stamp: {
        surface::StampDef def;
        def.side = kStampSide;
        read_length(table, "depth_mm", 1e-3, 0.15, 1.0, def.depth);
        if (tool.size > kLargestStamp)
          table.complain("size_mm", "size_mm is more than 30 for a stamp.", "Write 5 to 30.");
        for (const int motif : tool.motifs)
          if (!areas_[static_cast<std::size_t>(motif)])
            table.complain("motifs",
                           "the figure \"" + way_.figures[static_cast<std::size_t>(motif)].id +
                               "\" has no area, so a stamp of it presses nothing.",
                           "Draw an area: [[motif.ID.fill]].");
        return def;
      }
      case Law::resist: {
        surface::ResistDef def;
        read_length(table, "width_mm", 1e-3, 1.0, 30.0, def.width);
        return def;
      }
      case Law::coil: {
        surface::CoilDef def;
        read_length(table, "width_mm", 1e-3, 2.0, 15.0, def.width);
        read_length(table, "height_mm", 1e-3, 0.3, 3.0, def.height);
        table.integer("marks", def.marks, 8, 120);
        return def;
      }
      default: {
        surface::BurnishDef def;
        read_length(table, "width_mm", 1e-3, 1.0, 20.0, def.width);
        return def;
      }
    }
  }

  Way& way_;
  const std::vector<std::string>& languages_;
  std::vector<bool> areas_;  // by Way::figures: an area is written
};

}  // namespace

WayRead read_way(const std::filesystem::path& toml, const std::vector<std::string>& languages) {
  WayRead read;
  read.way.id = toml.stem().string();
  toml::TomlReader reader(toml);
  Table root = reader.root();
  WayReader(read.way, languages).read(root);
  read.problems = reader.problems();
  read.keys_checked = reader.keys_checked();
  return read;
}

}  // namespace onggi::decoration
