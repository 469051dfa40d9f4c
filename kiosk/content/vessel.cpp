#include "kiosk/content/vessel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <new>

#include "engine/profile/measures.h"
#include "engine/profile/slices.h"
#include "kiosk/content/gltf.h"
#include "kiosk/content/pack.h"

namespace onggi::content {

namespace {

namespace fs = std::filesystem;

/// A vessel outside these heights was not modelled in metres.
constexpr double kLowest = 0.02, kHighest = 2.0;
constexpr double kAssumedHeight = 0.3;

/// The file's mesh, turned so that its axis is y and its foot stands at 0, times `scale`.
TriangleMesh upright(const TriangleMesh& mesh, const ExtractedProfile& found, double scale) {
  const AxisFrame f = axis_frame(found.axis_origin, found.axis_direction);
  TriangleMesh out;
  out.triangles = mesh.triangles;
  out.positions.reserve(mesh.positions.size());
  out.normals.reserve(mesh.normals.size());
  const auto turned = [&](Vec3 v) {
    return std::array<float, 3>{static_cast<float>(dot(v, f.across)),
                                static_cast<float>(dot(v, f.up)),
                                static_cast<float>(dot(v, f.along))};
  };
  for (const auto& p : mesh.positions)
    out.positions.push_back(turned((Vec3{p[0], p[1], p[2]} - f.origin) * scale));
  for (const auto& n : mesh.normals) out.normals.push_back(turned({n[0], n[1], n[2]}));
  return out;
}

/// "moon_jar" -> "Moon jar".
std::string title_of(const std::string& id) {
  std::string out = id;
  std::replace(out.begin(), out.end(), '_', ' ');
  if (!out.empty() && out[0] >= 'a' && out[0] <= 'z')
    out[0] = static_cast<char>(out[0] - 'a' + 'A');
  return out;
}

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// What file units are worth in metres.
double scale_for(Vessel& vessel, double height) {
  if (vessel.true_height > 0.0) return vessel.true_height / height;
  if (height >= kLowest && height <= kHighest) return 1.0;
  vessel.extracted.warnings.push_back("It is " + metres(height) +
                                      " units tall, so they are not metres; shown " +
                                      metres(kAssumedHeight) + " m tall, its true size unknown.");
  return kAssumedHeight / height;
}

Result<Vessel> load(Vessel vessel) {
  auto model = read_gltf(vessel.file);
  if (!model) return tl::unexpected<Problem>(model.error());
  auto found = extract_profile(model->mesh, {}, vessel.file.string());
  if (!found) return tl::unexpected<Problem>(found.error());
  vessel.extracted = std::move(*found);
  for (std::string& warning : model->warnings)
    vessel.extracted.warnings.push_back(std::move(warning));
  const double scale = scale_for(vessel, vessel.extracted.profile.height());
  vessel.mesh = upright(model->mesh, vessel.extracted, scale);
  vessel.extracted.profile = scaled(vessel.extracted.profile, scale);
  if (vessel.credit.empty()) vessel.credit = model->copyright;
  if (model->colored) vessel.color = model->base_color;
  return vessel;
}

Result<Vessel> load_pack(const fs::path& folder) {
  const PackRead read = read_pack(folder / "vessel.toml");
  if (!read.problems.empty()) return tl::unexpected<Problem>(read.problems.front());
  const Pack& pack = read.pack;
  Vessel vessel;
  vessel.id = folder.filename().string();
  vessel.file = folder / "vessel.glb";
  std::error_code ignored;
  if (!fs::exists(vessel.file, ignored) && fs::exists(folder / "vessel.gltf", ignored))
    vessel.file = folder / "vessel.gltf";
  if (!fs::exists(vessel.file, ignored))
    return problem(folder.string(), "it has no vessel.glb.",
                   pack.drawing.empty()
                       ? "Put the vessel's mesh into the folder as vessel.glb."
                       : "Make it: onggi vessel make " + (folder / pack.drawing).string() + " -o " +
                             vessel.file.string());
  vessel.labels = pack.labels;
  vessel.credit = pack.credit_line();
  vessel.licence = pack.licence;
  vessel.source = pack.source;
  vessel.true_height = pack.true_height;
  auto loaded = load(std::move(vessel));
  if (loaded && pack.color) loaded->color = *pack.color;
  return loaded;
}

}  // namespace

Label Vessel::label(const std::string& language) const {
  for (const std::string& wanted : {language, std::string("en")})
    if (const auto found = labels.find(wanted); found != labels.end()) return found->second;
  Label made;
  made.title = title_of(id);
  return made;
}

const Vessel* Catalogue::find(const std::string& id) const {
  for (const Vessel& vessel : vessels)
    if (vessel.id == id) return &vessel;
  return nullptr;
}

Result<Vessel> load_vessel(const fs::path& path) {
  try {
    // "pack/" names the folder as "pack" does.
    const fs::path named = path.filename().empty() ? path.parent_path() : path;
    std::error_code ignored;
    if (fs::exists(named / "vessel.toml", ignored)) return load_pack(named);
    Vessel vessel;
    vessel.id = named.stem().string();
    vessel.file = named;
    return load(std::move(vessel));
  } catch (const std::bad_alloc&) {
    return problem(path.string(), "it needs more memory than there is.",
                   "Export the vessel with fewer triangles.");
  }
}

}  // namespace onggi::content
