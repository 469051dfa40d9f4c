#include "kiosk/app/visit_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace onggi::app {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Dimensions& d) {
  return {{"height", d.height}, {"belly", d.belly},         {"belly_height", d.belly_height},
          {"mouth", d.mouth},   {"neck", d.neck},           {"neck_height", d.neck_height},
          {"foot", d.foot},     {"wall_mean", d.wall_mean}, {"wall_evenness", d.wall_evenness}};
}

Json json_of(const Measures& m) {
  return {{"scale", m.scale},
          {"outline_overlap", m.outline_overlap},
          {"outline_rms", m.outline_rms},
          {"outline_worst", m.outline_worst},
          {"outline_worst_at", m.outline_worst_at},
          {"outline_worst_sign", m.outline_worst_sign},
          {"outline_worst_firm", m.outline_worst_firm},
          {"volume_overlap", m.volume_overlap},
          {"turning_rms_degrees", m.turning_rms * 57.29577951308232},
          {"target", json_of(m.target)},
          {"made", json_of(m.made)}};
}

std::vector<std::string> files_of(const KeptVisit& kept) {
  std::vector<std::string> files;
  if (!kept.saved || !*kept.saved) return files;
  const souvenir::KeepsakeFiles& saved = **kept.saved;
  for (const auto& file : {saved.png, saved.jpeg, saved.glb, saved.stl, saved.replay})
    if (!file.empty()) files.push_back(file.string());
  return files;
}

}  // namespace

std::string hash_text(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

std::string measures_json(const Measures& m) { return json_of(m).dump(); }

std::string visit_report(const KeptVisit& kept, const std::vector<std::filesystem::path>& screens) {
  Json report;
  report["vessel"] = kept.vessel_id;
  report["score"] = kept.score.points;
  report["stars"] = kept.score.stars;
  report["glaze"] = kept.glaze;
  report["thrown_height"] = kept.thrown_height;
  report["height"] = kept.height;
  report["measures"] = json_of(kept.score.measures);
  report["state_hash"] = hash_text(kept.state_hash);
  report["ticks"] = kept.ticks;
  report["screens"] = Json::array();
  for (const auto& screen : screens) report["screens"].push_back(screen.string());
  report["files"] = files_of(kept);
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string visit_summary(const KeptVisit& kept) {
  char score[64];
  std::snprintf(score, sizeof score, "%.1f of 100, %d of 5 stars", kept.score.points,
                kept.score.stars);
  std::string text = kept.vessel_id + ": " + score + "\n";
  const auto files = files_of(kept);
  if (!files.empty()) text += "The keepsake picture: " + files.front() + "\n";
  return text;
}

}  // namespace onggi::app
