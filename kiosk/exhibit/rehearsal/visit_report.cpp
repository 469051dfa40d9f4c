#include "kiosk/exhibit/rehearsal/visit_report.h"

#include <cstdio>

#include "engine/base/plain_text.h"

namespace onggi::rehearsal {

namespace {

using files::Json;

Json json_of(const Dimensions& d) {
  return Json::object({{"height", d.height},
                       {"belly", d.belly},
                       {"belly_height", d.belly_height},
                       {"mouth", d.mouth},
                       {"neck", d.neck},
                       {"neck_height", d.neck_height},
                       {"foot", d.foot},
                       {"opening", d.opening},
                       {"wall_mean", d.wall_mean},
                       {"wall_evenness", d.wall_evenness}});
}

std::vector<std::string> files_of(const exhibit::KeptVisit& kept) {
  std::vector<std::string> files;
  if (!kept.saved || !*kept.saved) return files;
  const souvenir::KeepsakeFiles& saved = **kept.saved;
  for (const auto& file : {saved.postcard, saved.print, saved.glb, saved.replay})
    if (!file.empty()) files.push_back(file.string());
  if (kept.turning && *kept.turning) files.push_back((*kept.turning)->string());
  return files;
}

}  // namespace

std::string hash_text(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

Json json_of(const Measures& m) {
  return Json::object({{"scale", m.scale},
                       {"outline_overlap", m.outline_overlap},
                       {"outline_rms", m.outline_rms},
                       {"outline_worst", m.outline_worst},
                       {"out_of_round_m", m.out_of_round},
                       {"outline_worst_at", m.outline_worst_at},
                       {"outline_worst_sign", m.outline_worst_sign},
                       {"outline_worst_firm", m.outline_worst_firm},
                       {"outline_worst_firm_at", m.common_firm_at},
                       {"volume_overlap", m.volume_overlap},
                       {"turning_rms_degrees", m.turning_rms * 57.29577951308232},
                       {"opening_lacking", m.opening_lacking},
                       {"target", json_of(m.target)},
                       {"made", json_of(m.made)}});
}

Json visit_report(const exhibit::KeptVisit& kept, const std::vector<std::filesystem::path>& screens,
                  const std::optional<ScriptedVisitor::Looks>& looks) {
  Json pictures = Json::list();
  for (const auto& screen : screens) pictures.push_back(screen.string());
  Json report = Json::object({{"vessel", kept.vessel_id},
                              {"score", kept.score.points},
                              {"stars", kept.score.stars},
                              {"glaze", kept.glaze},
                              {"thrown_height", kept.thrown_height},
                              {"height", kept.height},
                              {"measures", json_of(kept.score.measures)},
                              {"state_hash", hash_text(kept.state_hash)},
                              {"ticks", kept.ticks},
                              {"screens", pictures},
                              {"files", Json::list_of(files_of(kept))}});
  Json asked = Json::object();
  for (const score::Remark& one : kept.score.asked) {
    Json figures = Json::object();
    for (const auto& [place, value] : one.places) figures[place] = std::stol(value);
    asked[one.key] = std::move(figures);
  }
  if (!kept.score.asked.empty()) report["asked"] = std::move(asked);
  if (looks)
    report["naive"] =
        Json::object({{"roughness", looks->end.roughness},
                      {"ledge", looks->end.ledge},
                      {"handsome_at", looks->handsome_at ? Json(*looks->handsome_at) : Json()}});
  return report;
}

std::string visit_summary(const exhibit::KeptVisit& kept) {
  char score[64];
  std::snprintf(score, sizeof score, "%.1f of 100, %d of 5 stars", kept.score.points,
                kept.score.stars);
  std::string text = terminal::plain(kept.vessel_id) + ": " + score + "\n";
  const auto files = files_of(kept);
  if (!files.empty()) text += "The keepsake picture: " + terminal::plain(files.front()) + "\n";
  return text;
}

}  // namespace onggi::rehearsal
