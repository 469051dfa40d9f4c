#include "kiosk/program/commands/vessel_json.h"

namespace onggi::commands {

using files::Json;

namespace {

const char* name_of(UpFrom from) {
  switch (from) {
    case UpFrom::opening:
      return "opening";
    case UpFrom::file:
      return "file";
    case UpFrom::foot:
      return "foot";
    case UpFrom::handles:
      return "handles";
    case UpFrom::mass:
      return "mass";
    case UpFrom::given:
      break;
  }
  return "given";
}

}  // namespace

const char* name_of(InnerWall wall) {
  return wall == InnerWall::measured   ? "measured"
         : wall == InnerWall::inferred ? "inferred"
                                       : "none";
}

Json vessel_json(const content::Vessel& vessel) {
  const ExtractedProfile& e = vessel.extracted;
  Json outer = Json::list(), inner = Json::list(), nodes = Json::list();
  Json seen_list = Json::list();
  std::size_t seen = 0, walled = 0;
  for (std::size_t i = 0; i < e.profile.points.size(); ++i) {
    const ProfilePoint& p = e.profile.points[i];
    outer.push_back(Json::list({p.height, p.outer}));
    if (p.inner <= 0) continue;
    const bool both = i < e.inner_seen.size() && e.inner_seen[i];
    inner.push_back(Json::list({p.height, p.inner}));
    seen_list.push_back(both);
    ++walled;
    if (both) ++seen;
  }
  for (const auto& node : vessel.nodes)
    nodes.push_back(Json::object({{"name", node.name}, {"triangles", node.triangles}}));
  const auto vec = [](Vec3 v) { return Json::list({v.x, v.y, v.z}); };
  return Json::object({{"file", vessel.file.string()},
                       {"nodes", nodes},
                       {"triangles", vessel.mesh.triangles.size()},
                       {"height_m", e.profile.height()},
                       {"metres_per_unit", vessel.unit},
                       {"size_from", content::name_of(vessel.size_from)},
                       {"axis", Json::object({{"origin", vec(e.axis_origin)},
                                              {"direction", vec(e.axis_direction)}})},
                       {"up", vec(e.axis_direction)},
                       {"up_from", name_of(e.up_from)},
                       {"up_sure", e.up_sure},
                       {"symmetry", e.symmetry},
                       {"masked_fraction", e.masked_fraction},
                       {"inner", name_of(e.profile.inner_wall)},
                       {"inner_measured_share",
                        walled > 0 ? static_cast<double>(seen) / static_cast<double>(walled) : 0.0},
                       {"inferred_wall_m", e.inferred_wall},
                       {"inner_seen", seen_list},
                       {"outer", outer},
                       {"inner_profile", inner},
                       {"warnings", Json::list_of(e.warnings)},
                       {"licence", vessel.licence},
                       {"credit", vessel.credit}});
}

}  // namespace onggi::commands
