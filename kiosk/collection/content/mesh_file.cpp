#include "kiosk/collection/content/mesh_file.h"

#include <algorithm>
#include <span>

#include "kiosk/collection/content/mesh_parts.h"
#include "kiosk/collection/content/vessel_file.h"
#include "kiosk/ground/files/helper_process.h"

namespace onggi::content {

namespace {

namespace fs = std::filesystem;

/// Limits of the reader beyond what the file's size needs: MiB, and seconds of processor time.
constexpr std::size_t kMemoryMib = 768, kMemoryTimesFile = 12, kMostMemoryMib = 6144;
constexpr int kSeconds = 2, kSecondsMib = 1, kMostSeconds = 20;

std::string ending_of(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

bool is_gltf(const std::string& ending) { return ending == ".glb" || ending == ".gltf"; }

GltfModel model_of(std::vector<MeshPart> parts) {
  GltfModel model;
  const bool colored = std::any_of(parts.begin(), parts.end(),
                                   [](const MeshPart& part) { return !part.colors.empty(); });
  std::array<std::uint8_t, 3> clay;
  for (std::size_t k = 0; k < 3; ++k) clay[k] = display_of(kClayColor[k]);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    MeshPart& from = parts[i];
    GltfPart part;
    part.node = static_cast<int>(i);
    part.name = std::move(from.name);
    part.mesh = true;
    part.first_position = model.mesh.positions.size();
    part.first_triangle = model.mesh.triangles.size();
    part.positions = part.own_positions = from.positions.size();
    part.triangles = part.own_triangles = from.triangles.size();
    const auto base = static_cast<std::uint32_t>(part.first_position);
    model.mesh.positions.insert(model.mesh.positions.end(), from.positions.begin(),
                                from.positions.end());
    auto& colors = model.coloring.colors;
    colors.insert(colors.end(), from.colors.begin(), from.colors.end());
    if (colored) colors.resize(model.mesh.positions.size(), clay);
    for (const auto& t : from.triangles)
      model.mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    model.parts.push_back(std::move(part));
  }
  return model;
}

Result<GltfModel> read_by_helper(const fs::path& file, const std::string& ending,
                                 const settings::ReaderLimits& limits) {
  const std::string name = file.string();
  const auto bytes = read_vessel_file(file, static_cast<std::size_t>(limits.file_mb) << 20);
  if (!bytes) return tl::unexpected<Problem>(bytes.error());
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (error)
    return problem("/proc/self/exe",
                   "The kiosk cannot find its own folder: " + error.message() + ".", "Mount /proc.",
                   1);
  const std::size_t mib =
      std::min(kMostMemoryMib, kMemoryMib + kMemoryTimesFile * (bytes->size() >> 20));
  const int seconds = static_cast<int>(
      std::min<std::size_t>(kMostSeconds, kSeconds + kSecondsMib * (bytes->size() >> 20)));
  const auto vertices = static_cast<std::size_t>(limits.vertices),
             triangles = static_cast<std::size_t>(limits.triangles);
  const auto answer = files::run_helper(
      {.program = (self.parent_path() / "onggi-mesh").string(),
       .arguments = {ending.substr(1), std::to_string(vertices), std::to_string(triangles),
                     std::to_string(mib), std::to_string(seconds)},
       .body = std::span(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()),
       .timeout_s = 2.0 * kMostSeconds,
       .most_bytes = 15 * vertices + 12 * triangles + (1u << 20),
       .answer = "mesh"});
  if (!answer)
    return problem(name, "it cannot be read: " + answer.error().what,
                   "Export the vessel again, best as GLB. If no file of this kind can be read: " +
                       answer.error().remedy);
  auto parts = parts_of(*answer, name);
  if (!parts) return tl::unexpected<Problem>(parts.error());
  GltfModel model = model_of(std::move(*parts));
  if (model.mesh.triangles.empty())
    return problem(name, "it has no triangles.", "Export the vessel's surface.");
  return model;
}

}  // namespace

bool is_mesh_ending(const std::string& ending) {
  return is_gltf(ending) || ending == ".obj" || ending == ".ply" || ending == ".stl";
}

double format_unit(const fs::path& file) { return is_gltf(ending_of(file)) ? 1.0 : 0.0; }

Result<GltfModel> read_mesh_file(const fs::path& file, const settings::ReaderLimits& limits) {
  const std::string ending = ending_of(file);
  if (is_mesh_ending(ending) && !is_gltf(ending)) return read_by_helper(file, ending, limits);
  return read_gltf(file, limits);
}

}  // namespace onggi::content
