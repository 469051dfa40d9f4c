#include "kiosk/lab/measure/scene_page.h"

#include <algorithm>
#include <filesystem>

#include "engine/base/nearest_name.h"
#include "engine/lab/scene_fields.h"
#include "kiosk/collection/settings/scene_words.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/lab/measure/middle.h"
#include "kiosk/lab/measure/scene_presets.h"

namespace onggi::measure {

namespace {

constexpr std::size_t kMostText = 1 << 20;
constexpr double kFirstPot = 60;  // points: the least that a first pot should get

std::string said(const char* format, double a, double b) {
  char words[160];
  std::snprintf(words, sizeof words, format, a, b);
  return words;
}

/// Median points of the careful hand's pots, and how many got five stars.
std::string careful_of(const NaiveTable& table) {
  std::vector<double> points;
  int five = 0;
  for (const HeadlessOutcome& one : table.careful) {
    points.push_back(one.looks.front().points);
    five += one.looks.front().stars >= 5 ? 1 : 0;
  }
  if (points.empty()) return "not thrown";
  return said("%.0f; five stars %.0f", middle(points), five) + " of " +
         std::to_string(points.size());
}

}  // namespace

Result<std::vector<SceneEntry>> measure_scenes(const NaivePlan& plan, std::FILE* progress) {
  const auto root = files::program_root();
  if (!root) return tl::unexpected(root.error());
  const auto presets = read_presets();
  if (!presets) return tl::unexpected(presets.error());
  std::vector<SceneEntry> scenes;
  for (const ScenePreset& preset : *presets) {
    if (preset.def.paper || preset.def.building) continue;  // nobody throws there
    const std::filesystem::path file = *root / "config/scenes" / (preset.name + ".toml");
    const auto bytes = files::read_file(file, kMostText);
    if (!bytes)
      return problem(file.string(), "It cannot be read.", "Check its permissions and its size.");
    SceneEntry scene;
    scene.name = preset.name;
    scene.words = settings::words_of_scene({bytes->begin(), bytes->end()});
    const std::vector<std::string> names = lab::effect_names();
    for (std::size_t n = 0; n < names.size(); ++n)
      if (lab::has_effect(preset.def, n)) scene.effects.push_back(names[n]);
    auto bill = tuning::bill_of(preset.name, preset.def, 1);
    if (!bill) return tl::unexpected(bill.error());
    scene.bill = std::move(*bill);
    NaivePlan visits = plan;
    visits.scene = file.string();
    visits.careful = true;
    auto table = measure_naive(visits, progress);
    if (!table) return tl::unexpected(table.error());
    scene.visits = std::move(*table);
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

std::string page_of(const std::vector<SceneEntry>& scenes, const PageMade& made) {
  std::string page =
      "# The scenes, and what each costs and gives\n\nFor curators and for whoever wonders what a "
      "scene costs.\n\nMade by `" +
      made.command + "`";
  if (!scenes.empty()) page += " on " + scenes.front().bill.machine;
  page += ", " + made.date + (made.commit.empty() ? "" : ", of commit " + made.commit) +
          ". Write nothing here by hand.\n";
  for (const SceneEntry& scene : scenes) {
    page += "\n## " + scene.name + "\n" + scene.words + "\n";
    for (const NaiveLine& line : scene.visits.lines)
      if (line.vessel == "all" && line.points < kFirstPot)
        page += said(
            "\n**Not for a first pot: half of those who never threw get %.0f points of 100 "
            "or fewer in %.0f s.**\n",
            line.points, line.seconds);
    page += "\n| | |\n|---|---|\n";
    page += "| simulates | " + (scene.effects.empty() ? "contact alone" : joined(scene.effects)) +
            " |\n";
    page += "| costs | " + said("%.1f of a tick's 1000 us, contact alone %.1f", scene.bill.whole_us,
                                scene.bill.contact_us);
    if (!scene.bill.lines.empty()) page += "; dearest " + scene.bill.lines.front().effect;
    page += " |\n";
    for (const NaiveLine& line : scene.visits.lines)
      if (line.vessel == "all")
        page += "| naive hands, " +
                said("%.0f s | %.0f points in the median", line.seconds, line.points) +
                said(" (least %.0f), roughness %.2f mm", line.least_points, 1e3 * line.roughness) +
                ", five stars " + std::to_string(line.five_stars) + " of " +
                std::to_string(line.visits) + " |\n";
    page += "| a careful hand | " + careful_of(scene.visits) + " |\n";
  }
  return page;
}

}  // namespace onggi::measure
