#include "kiosk/collection/settings/scene_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/base/nearest_name.h"
#include "engine/scene/lump.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::settings {
namespace {

using Table = toml::TomlReader::Table;

constexpr double kAny = std::numeric_limits<double>::infinity();
const std::string kPaddle = "paddle";

/// Reads fields without checking ranges, because only the engine's validate() knows them.
class SceneReader {
 public:
  SceneReader(toml::TomlReader& reader, SceneDef& def) : root_(reader.root()), def_(def) {}

  void read() {
    read_quality();
    each_part(def_, [&]<class Part>(Part& part) {
      read_table(Part::kName, [&] {
        read_fields(part);
        if constexpr (std::is_same_v<Part, ToolDef>) read_to_hand();
      });
      if constexpr (std::is_same_v<Part, ToolDef>)
        for (SceneTool& tool : def_.tools) read_tool(tool);
    });
    each_effect(def_, [&]<class Def>(std::optional<Def>& effect) {
      read_effect(Def::kName, effect, [&](Def& written) {
        if constexpr (std::is_same_v<Def, KilnDef>) read_body(written);
        if constexpr (std::is_same_v<Def, PrintsDef>) read_paddle(written);
        read_fields(written);
      });
    });
    read_effect(PaperDef::kName, def_.paper, [&](PaperDef& paper) { read_fields(paper); });
    if (def_.paper)
      each_effect(def_, [&]<class Def>(std::optional<Def>& effect) {
        if (!effect) return;
        root_.child(Def::kName)
            .complain("",
                      std::string(Def::kName) +
                          " cannot be combined with [paper], whose model has no effects.",
                      std::string("Remove [") + Def::kName + "] or [paper].");
        leave_out(Def::kName, effect);
      });
    root_.finish();
  }

  bool auto_quality() const { return auto_quality_; }

  /// The engine has room for more than a kiosk has: with 33.5 million elements a frame took 12 s
  /// and the program 1.6 GB, and the watchdog ended it.
  void bound_grid() {
    constexpr int kMostOfAScene = 4 << 20;
    const long long elements = 1LL * def_.clay.rows * def_.clay.sectors;
    if (elements <= kMostOfAScene) return;
    tell({"clay.rows",
          "clay.rows times sectors makes " + std::to_string(elements) +
              " elements, but a kiosk draws at most " + std::to_string(kMostOfAScene) + ".",
          "Lower rows or sectors: 400 x 360 is enough for the eye and the hand."});
    put_back("clay.rows");
  }

  /// The engine simulates a lump that flows apart of itself. Nobody can throw a pot of one: it has
  /// fallen before a hand is there. A straight wall bears sqrt(3) yield_stress (SlumpDef).
  bool bound_strength() {
    if (!def_.slump) return true;
    constexpr double kRoot3 = 1.7320508075688772, kGravity = 9.81;
    // A visit's lump is as tall as its vessel, whatever clay.height is.
    const double least = def_.slump->density * kGravity * scene::kTallestTarget / kRoot3;
    if (def_.slump->yield_stress >= least) return true;
    tell({"slump.yield_stress",
          "yield_stress is too low for the lump of the tallest vessel, " +
              whole(1000.0 * scene::kTallestTarget) +
              " mm: it sinks under its own weight before a hand is there.",
          "Write at least " + whole(std::ceil(least)) + "."});
    if (!put_back("slump.yield_stress")) leave_out(SlumpDef::kName, def_.slump);
    return false;
  }

  /// Thrown walls are 3 to 8 mm thick. Where all that is thinner than this tears, no visitor gets
  /// to an end, and each frame draws a pot that is torn from foot to rim.
  bool bound_tearing() {
    constexpr double kMostOfAThrow = 0.005;  // m
    if (!def_.walls || def_.walls->tear_thickness <= kMostOfAThrow) return true;
    tell({"walls.tear_thickness",
          "tear_thickness is more than 5 mm: every pot tears before its wall is thrown.",
          "Write at most 0.005; 0.0025 is what clay does."});
    if (!put_back("walls.tear_thickness")) leave_out(WallsDef::kName, def_.walls);
    return false;
  }

  /// Asks the engine until it finds nothing more, and then for what a kiosk cannot show; each
  /// refused field is reported at its line and gets its default.
  void check() {
    for (;;) {
      const Result<void> good = validate(def_);
      if (good && bound_strength() && bound_tearing()) return bound_grid();
      if (good) continue;
      tell(good.error());
      if (!put_back(good.error().where)) {
        def_ = SceneDef{};
        return;
      }
    }
  }

 private:
  static std::string whole(double number) { return std::to_string(std::llround(number)); }
  void read_quality() {
    std::string word;
    if (!root_.text("quality", word)) return;
    auto_quality_ = word == "auto";
    if (!auto_quality_ && word != "fixed")
      root_.complain("quality", "\"" + word + "\" is not a valid quality.",
                     "Write \"auto\" to find the grid on this machine, or \"fixed\".");
  }
  template <class Def>
  void read_fields(Def& def) {
    each_field<Def>([&](const auto& field) {
      if constexpr (std::is_same_v<decltype(def.*(field.value)), double&>)
        if (field.formerly != nullptr) read_renamed(field.key, field.formerly, def.*(field.value));
      if constexpr (std::is_same_v<Def, PrintsDef>)
        if (field.key == kPaddle) return;  // a word
      value(field.key, def.*(field.value));
    });
  }
  /// Files that have a field's old key still mean it; the check asks for the new one.
  void read_renamed(const std::string& key, const std::string& formerly, double& field) {
    if (!table_.has(formerly)) return;
    const double before = field;
    if (table_.number(formerly, field, -kAny, kAny))
      put_back_[name_ + "." + key] = [&field, before] { field = before; };
    table_.complain(formerly, formerly + " is the old name of " + key + ".",
                    "Write " + key + " in its place. Until then the kiosk reads it as that.");
  }
  /// Reads a clay by name; numbers written beside it override it.
  void read_body(KilnDef& kiln) {
    std::string name;
    if (!table_.text("body", name)) return;
    if (const ClayBody* body = find_clay_body(name)) {
      kiln.drying_shrinkage = body->drying_shrinkage;
      kiln.firing_shrinkage = body->firing_shrinkage;
      return;
    }
    std::vector<std::string> all;
    for (const ClayBody& body : clay_bodies()) all.emplace_back(body.name);
    const std::string nearest = nearest_name(name, all);
    table_.complain(
        "body", "\"" + name + "\" is not a known clay body.",
        nearest.empty() ? "Write one of " + joined(all) + "." : "Did you mean " + nearest + "?");
  }
  void read_paddle(PrintsDef& prints) {
    std::string name;
    if (!table_.text(kPaddle, name)) return;
    if (const auto face = find_paddle_face(name)) {
      prints.paddle = *face;
      return;
    }
    const std::vector<std::string> all(paddle_faces().begin(), paddle_faces().end());
    const std::string nearest = nearest_name(name, all);
    table_.complain(
        kPaddle, "\"" + name + "\" is no face of a paddle.",
        nearest.empty() ? "Write one of " + joined(all) + "." : "Did you mean " + nearest + "?");
  }
  /// Reads the tools by name; all if the scene names none. The engine sets their order.
  void read_to_hand() {
    std::vector<std::string> named;
    if (!table_.texts("to_hand", named)) return;
    std::vector<std::string> all;
    for (const SceneTool& tool : def_.tools) all.push_back(tool.name);
    for (std::size_t i = 0; i < named.size(); ++i) {
      if (std::find(all.begin(), all.end(), named[i]) != all.end()) continue;
      const std::string nearest = nearest_name(named[i], all);
      table_.complain_at("to_hand", i, "\"" + named[i] + "\" is not a known tool.",
                         nearest.empty() ? "Write one or more of " + joined(all) + "."
                                         : "Did you mean " + nearest + "?");
    }
    std::erase_if(def_.tools, [&](const SceneTool& tool) {
      return std::find(named.begin(), named.end(), tool.name) == named.end();
    });
  }
  void read_tool(SceneTool& tool) {
    read_table(tool.name, [&] {
      value("radius", tool.size.radius);
      value("length", tool.size.length);
      value("thickness", tool.size.thickness);
    });
  }
  void read_table(const std::string& name, const std::function<void()>& fields) {
    name_ = name;
    table_ = root_.child(name);
    fields();
    table_.finish();
  }
  /// An effect is on if its table is written, whatever SceneDef's default is.
  template <class Def, class Fields>
  void read_effect(const std::string& name, std::optional<Def>& effect, const Fields& fields) {
    effect.reset();
    read_table(name, [&] {
      if (table_.present()) fields(effect.emplace());
    });
  }
  /// Treats the table as not written.
  template <class Def>
  void leave_out(const std::string& name, std::optional<Def>& effect) {
    std::erase_if(put_back_,
                  [&](const auto& entry) { return entry.first.starts_with(name + "."); });
    effect.reset();
  }
  void value(const std::string& key, double& field) {
    const double before = field;
    if (table_.number(key, field, -kAny, kAny)) {
      put_back_[name_ + "." + key] = [&field, before] { field = before; };
    }
  }
  void value(const std::string& key, int& field) {
    const int before = field;
    if (table_.integer(key, field, std::numeric_limits<int>::min(),
                       std::numeric_limits<int>::max())) {
      put_back_[name_ + "." + key] = [&field, before] { field = before; };
    }
  }

  void value(const std::string& key, bool& field) { table_.boolean(key, field); }

  void tell(const Problem& problem) {
    const std::size_t dot = problem.where.find('.');
    const std::string key = dot == std::string::npos ? "" : problem.where.substr(dot + 1);
    root_.child(problem.where.substr(0, dot)).complain(key, problem.what, problem.remedy);
  }

  /// Resets `field` to its default. If the file does not write it, resets every field of its table,
  /// because one of those contradicts the default. False if there is nothing to reset.
  bool put_back(const std::string& field) {
    // An effect that needs another effect: the field is the effect itself.
    if (field.find('.') == std::string::npos) {
      bool found = false;
      each_effect(def_, [&]<class Def>(std::optional<Def>& effect) {
        if (field != Def::kName || !effect) return;
        leave_out(field, effect);
        found = true;
      });
      return found;
    }
    if (const auto found = put_back_.find(field); found != put_back_.end()) {
      found->second();
      put_back_.erase(found);
      return true;
    }
    const std::string prefix = field.substr(0, field.find('.') + 1);
    return std::erase_if(put_back_, [&](const auto& entry) {
             if (!entry.first.starts_with(prefix)) return false;
             entry.second();
             return true;
           }) > 0;
  }

  Table root_, table_;
  SceneDef& def_;
  bool auto_quality_ = false;
  std::string name_;
  std::map<std::string, std::function<void()>> put_back_;  // by "table.key"
};

}  // namespace

SceneRead read_scene(const std::filesystem::path& file) {
  SceneRead read;
  toml::TomlReader reader(file);
  if (reader.ok()) {
    SceneReader scene(reader, read.def);
    scene.read();
    scene.check();
    read.auto_quality = scene.auto_quality() && !read.def.paper;
  }
  read.problems = reader.problems();
  read.keys_checked = reader.keys_checked();
  return read;
}

}  // namespace onggi::settings
