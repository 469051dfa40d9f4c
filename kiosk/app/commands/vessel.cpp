#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/profile/measures.h"
#include "kiosk/app/commands/commands.h"
#include "kiosk/app/log.h"
#include "kiosk/content/drawing.h"
#include "kiosk/content/model.h"
#include "kiosk/content/vessel.h"
#include "kiosk/souvenir/durable_file.h"

namespace onggi::app {

namespace {

using Json = nlohmann::ordered_json;

Result<void> make(const std::string& drawing_file, const std::string& out) {
  const auto drawing = content::read_drawing(drawing_file);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto glb = content::make_glb(*drawing);
  if (auto good = souvenir::write_durably(out, glb); !good) return good;
  std::cout << out << ": " << drawing->title << ", " << glb.size() / 1024 << " kB\n";
  return {};
}

Json json_of(const content::Vessel& vessel) {
  const ExtractedProfile& e = vessel.extracted;
  Json outer = Json::array(), inner = Json::array();
  for (const ProfilePoint& p : e.profile.points) {
    outer.push_back({p.height, p.outer});
    if (p.inner > 0) inner.push_back({p.height, p.inner});
  }
  const auto vec = [](Vec3 v) { return Json::array({v.x, v.y, v.z}); };
  Json report;
  report["file"] = vessel.file.string();
  report["triangles"] = vessel.mesh.triangles.size();
  report["height_m"] = e.profile.height();
  report["axis"] = {{"origin", vec(e.axis_origin)}, {"direction", vec(e.axis_direction)}};
  report["symmetry"] = e.symmetry;
  report["masked_fraction"] = e.masked_fraction;
  report["inner"] = e.profile.inner_wall == InnerWall::measured   ? "measured"
                    : e.profile.inner_wall == InnerWall::inferred ? "inferred"
                                                                  : "none";
  report["outer"] = std::move(outer);
  report["inner_profile"] = std::move(inner);
  report["warnings"] = e.warnings;
  report["licence"] = vessel.licence;
  report["credit"] = vessel.credit;
  return report;
}

Result<void> inspect(const std::string& file, const std::string& json_file) {
  const auto vessel = content::load_vessel(file);
  if (!vessel) return tl::unexpected(vessel.error());
  const Json report = json_of(*vessel);
  const std::string text = report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  if (json_file == "-") {
    std::cout << text;
    return {};
  }
  if (!json_file.empty())
    if (auto good = souvenir::write_durably(json_file, std::as_bytes(std::span(text))); !good)
      return good;
  const Profile& profile = vessel->extracted.profile;
  const Dimensions d = dimensions(profile);
  std::printf(
      "%s\n  height %.1f mm, widest %.1f mm at %.1f mm, mouth %.1f mm, foot %.1f mm\n"
      "  wall %.1f mm (%s), symmetry %.3f, %.1f %% masked\n",
      vessel->file.c_str(), d.height * 1e3, d.belly * 1e3, d.belly_height * 1e3, d.mouth * 1e3,
      d.foot * 1e3, d.wall_mean * 1e3, report["inner"].get<std::string>().c_str(),
      vessel->extracted.symmetry, vessel->extracted.masked_fraction * 100);
  for (const std::string& warning : vessel->extracted.warnings)
    std::printf("  note: %s\n", warning.c_str());
  return {};
}

}  // namespace

void add_vessel(CLI::App& app, int& exit_code) {
  struct Arguments {
    std::string drawing, out = "vessel.glb", file, json;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("vessel", "Make a vessel from a drawing, or look into one");
  command->require_subcommand(1);
  command->footer("Example: onggi vessel make content/vessels/moon_jar/profile.toml -o vessel.glb");

  CLI::App* maker = command->add_subcommand("make", "Turn a drawn profile into a GLB");
  maker->footer("Example: onggi vessel make profile.toml -o vessel.glb");
  maker->add_option("drawing", arguments->drawing, "The drawing's TOML (kiosk/docs/curators.md)")
      ->required();
  maker->add_option("-o,--out", arguments->out, "The GLB to write [vessel.glb]");
  maker->callback([arguments, &exit_code] {
    if (auto good = make(arguments->drawing, arguments->out); !good)
      exit_code = exit_with(good.error());
  });

  CLI::App* inspector = command->add_subcommand("inspect", "Measure a vessel as a target");
  inspector->footer("Example: onggi vessel inspect vessel.glb --json -");
  inspector->add_option("file", arguments->file, "A GLB, a glTF or a vessel pack")->required();
  inspector->add_option("--json", arguments->json,
                        "Write all of it as JSON (- for standard output)");
  inspector->callback([arguments, &exit_code] {
    if (auto good = inspect(arguments->file, arguments->json); !good)
      exit_code = exit_with(good.error());
  });
}

}  // namespace onggi::app
