#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/profile/up.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/output.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/commands/up_option.h"
#include "kiosk/program/commands/vessel_json.h"

namespace onggi::commands {

namespace {

using files::Json;

struct LookArguments {
  std::string file;
  files::Output json{files::Output::Kind::json, "-"};
};

/// What the page asks about, and what it can fill in by itself.
Json asked_about(const content::Vessel& vessel) {
  Json out = vessel_json(vessel);
  const Vec3 up = vessel.extracted.axis_direction;
  out["node"] = vessel.node;
  out["up_axis"] = extraction::axis_name(up);
  out["down_axis"] = extraction::axis_name(-up);
  out["up_is_sure"] = vessel.extracted.up_sure >= ExtractedProfile::kSureUp;
  out["size_is_sure"] =
      content::is_known(vessel.size_from) || vessel.size_from == content::SizeFrom::file;
  out["title"] = vessel.label("en").title;
  out["institution"] = vessel.given.institution;
  return out;
}

Result<int> look(const LookArguments& arguments) {
  const auto vessels = content::load_vessels(arguments.file);
  Json out = Json::object({{"done", vessels.has_value()}});
  if (vessels) {
    Json list = Json::list();
    for (const content::Vessel& vessel : *vessels) list.push_back(asked_about(vessel));
    out["vessels"] = list;
  } else {
    out["what"] = vessels.error().what;
    out["remedy"] = vessels.error().remedy;
  }
  if (auto put = arguments.json.write(out.text(-1) + "\n"); !put)
    return tl::unexpected(put.error());
  return vessels ? 0 : 2;
}

}  // namespace

cli::Command look_command() {
  const auto a = std::make_shared<LookArguments>();
  return {.name = "look",
          .help = "Tell programs which vessels are in a scan, and what is in doubt about each",
          .examples = "Example: onggi vessel look scan.glb",
          .options = {{.name = "file",
                       .field = &a->file,
                       .help = "A scan, as for onggi vessel import",
                       .required = true},
                      {"--json", &a->json, "Write it into this file [standard output]"}},
          .run = [a] { return look(*a); }};
}

}  // namespace onggi::commands
