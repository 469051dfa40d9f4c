#include "kiosk/collection/content/gltf.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

#include "engine/math/vec.h"
#include "kiosk/collection/content/gltf_accessor.h"
#include "kiosk/collection/content/gltf_coloring.h"
#include "kiosk/collection/content/gltf_draco.h"
#include "kiosk/collection/content/vessel_file.h"

namespace onggi::content {

namespace {

/// Column-major, like glTF.
using Matrix = std::array<double, 16>;
constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix multiply(const Matrix& a, const Matrix& b) {
  Matrix out{};
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t k = 0; k < 4; ++k) out[c * 4 + r] += a[k * 4 + r] * b[c * 4 + k];
  return out;
}

Matrix matrix_of(const tinygltf::Node& node) {
  Matrix m = kIdentity;
  if (node.matrix.size() == 16) {
    std::copy(node.matrix.begin(), node.matrix.end(), m.begin());
    return m;
  }
  if (node.rotation.size() == 4) {
    double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3];
    const double norm = std::sqrt(x * x + y * y + z * z + w * w);
    if (norm > 0.0) {
      x /= norm, y /= norm, z /= norm, w /= norm;
      m = {1 - 2 * (y * y + z * z),
           2 * (x * y + z * w),
           2 * (x * z - y * w),
           0,
           2 * (x * y - z * w),
           1 - 2 * (x * x + z * z),
           2 * (y * z + x * w),
           0,
           2 * (x * z + y * w),
           2 * (y * z - x * w),
           1 - 2 * (x * x + y * y),
           0,
           0,
           0,
           0,
           1};
    }
  }
  if (node.scale.size() == 3)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t r = 0; r < 3; ++r) m[c * 4 + r] *= node.scale[c];
  if (node.translation.size() == 3)
    for (std::size_t r = 0; r < 3; ++r) m[12 + r] = node.translation[r];
  return m;
}

constexpr auto kNone = static_cast<std::size_t>(-1);

Vec3 column(const Matrix& m, std::size_t c) { return {m[c * 4], m[c * 4 + 1], m[c * 4 + 2]}; }

/// Gathers the primitives of all nodes into one mesh in world space.
class Gatherer {
 public:
  Gatherer(const GltfDocument& document, const settings::ReaderLimits& limits)
      : document_(document),
        model_(*document.model),
        limits_(limits),
        reader_(document, limits),
        colors_(document, limits) {}

  Result<void> walk_scene();
  Result<GltfModel> result();

 private:
  struct Visit {
    int node;
    Matrix parent;
    std::size_t above;  ///< Its parent's place in parents_.
  };
  Result<void> add_part(int node, const std::string& name, int mesh, const Matrix& world,
                        std::size_t above);
  void close_parts();
  Result<void> add_mesh(int index, const Matrix& world);
  Result<void> add_primitive(const tinygltf::Primitive& primitive, const DracoPrimitive* draco,
                             const Matrix& world, const std::string& where);
  Result<DecodedPrimitive> read_primitive(const tinygltf::Primitive& primitive,
                                          const std::string& where);
  void check_draco_bounds(const DecodedPrimitive& data, int accessor);
  std::vector<int> roots() const;

  const GltfDocument& document_;
  const tinygltf::Model& model_;
  const settings::ReaderLimits limits_;
  GltfReader reader_;
  GltfColors colors_;
  GltfModel out_;
  std::vector<std::size_t> parents_;  ///< The parent of each part.
  std::size_t corners_ = 0;           ///< Read so far, kept or not.
  std::vector<std::size_t> triangles_of_material_;
  std::size_t skipped_ = 0;
};

std::vector<int> Gatherer::roots() const {
  const auto scene = static_cast<std::size_t>(std::max(0, model_.defaultScene));
  if (scene < model_.scenes.size()) return model_.scenes[scene].nodes;
  std::vector<bool> child(model_.nodes.size(), false);
  for (const tinygltf::Node& node : model_.nodes)
    for (const int c : node.children)
      if (c >= 0 && static_cast<std::size_t>(c) < child.size())
        child[static_cast<std::size_t>(c)] = true;
  std::vector<int> out;
  for (std::size_t i = 0; i < child.size(); ++i)
    if (!child[i]) out.push_back(static_cast<int>(i));
  return out;
}

Result<void> Gatherer::walk_scene() {
  triangles_of_material_.assign(document_.materials.size(), 0);
  if (model_.nodes.empty()) {
    for (std::size_t i = 0; i < model_.meshes.size(); ++i)
      if (auto added = add_part(static_cast<int>(i), "", static_cast<int>(i), kIdentity, kNone);
          !added)
        return added;
    close_parts();
    return {};
  }
  std::vector<bool> seen(model_.nodes.size(), false);
  std::vector<Visit> stack;
  for (const int root : roots()) stack.push_back({root, kIdentity, kNone});
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const std::string here = document_.name + ", node " + std::to_string(visit.node);
    if (visit.node < 0 || static_cast<std::size_t>(visit.node) >= model_.nodes.size())
      return problem(here, "there is no such node.", "Export the vessel again.");
    const auto index = static_cast<std::size_t>(visit.node);
    if (seen[index])
      return problem(here, "it has two parents, or it is its own parent.",
                     "Give every node one parent, and export the vessel again.");
    seen[index] = true;
    const tinygltf::Node& node = model_.nodes[index];
    const Matrix world = multiply(visit.parent, matrix_of(node));
    const std::size_t here_in_parts = out_.parts.size();
    if (auto added = add_part(visit.node, node.name, node.mesh, world, visit.above); !added)
      return added;
    for (const int child : node.children) stack.push_back({child, world, here_in_parts});
  }
  close_parts();
  return {};
}

Result<void> Gatherer::add_part(int node, const std::string& name, int mesh, const Matrix& world,
                                std::size_t above) {
  GltfPart part;
  part.node = node;
  part.name = name;
  if (name.empty() && mesh >= 0 && static_cast<std::size_t>(mesh) < model_.meshes.size())
    part.name = model_.meshes[static_cast<std::size_t>(mesh)].name;
  part.first_position = out_.mesh.positions.size();
  part.first_triangle = out_.mesh.triangles.size();
  if (mesh >= 0)
    if (auto added = add_mesh(mesh, world); !added) return added;
  part.positions = out_.mesh.positions.size() - part.first_position;
  part.triangles = out_.mesh.triangles.size() - part.first_triangle;
  part.own_positions = part.positions;
  part.own_triangles = part.triangles;
  part.mesh = part.triangles > 0;
  out_.parts.push_back(std::move(part));
  parents_.push_back(above);
  return {};
}

/// A last-in, first-out walk finishes everything below a node before its neighbour, so each part is
/// one gapless run.
void Gatherer::close_parts() {
  for (std::size_t i = out_.parts.size(); i-- > 0;)
    if (parents_[i] != kNone) {
      out_.parts[parents_[i]].positions += out_.parts[i].positions;
      out_.parts[parents_[i]].triangles += out_.parts[i].triangles;
    }
  std::erase_if(out_.parts, [](const GltfPart& part) { return part.triangles == 0; });
}

Result<void> Gatherer::add_mesh(int index, const Matrix& world) {
  if (static_cast<std::size_t>(index) >= model_.meshes.size())
    return problem(document_.name + ", mesh " + std::to_string(index), "there is no such mesh.",
                   "Export the vessel again.");
  const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(index)];
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
    const std::string where =
        document_.name + ", mesh " +
        (mesh.name.empty() ? std::to_string(index) : "\"" + mesh.name.substr(0, 60) + "\"") +
        ", primitive " + std::to_string(p);
    const auto draco = document_.draco.find({index, static_cast<int>(p)});
    if (auto added =
            add_primitive(mesh.primitives[p],
                          draco == document_.draco.end() ? nullptr : &draco->second, world, where);
        !added)
      return added;
  }
  return {};
}

/// glTF 2.0, section 3.7.2.1: lists, strips and fans of triangles.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<std::uint32_t>& indices,
                                                       int mode) {
  std::vector<std::array<std::uint32_t, 3>> out;
  if (mode == TINYGLTF_MODE_TRIANGLES)
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
      out.push_back({indices[i], indices[i + 1], indices[i + 2]});
  if (mode == TINYGLTF_MODE_TRIANGLE_STRIP)
    for (std::size_t i = 0; i + 2 < indices.size(); ++i)
      out.push_back({indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
  if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
    for (std::size_t i = 1; i + 1 < indices.size(); ++i)
      out.push_back({indices[0], indices[i], indices[i + 1]});
  return out;
}

Result<DecodedPrimitive> Gatherer::read_primitive(const tinygltf::Primitive& primitive,
                                                  const std::string& where) {
  DecodedPrimitive out;
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) return out;
  auto positions = reader_.vectors(position->second, where);
  if (!positions) return tl::unexpected<Problem>(positions.error());
  out.positions = std::move(*positions);
  if (const auto normal = primitive.attributes.find("NORMAL");
      normal != primitive.attributes.end()) {
    auto normals = reader_.vectors(normal->second, where);
    if (!normals) return tl::unexpected<Problem>(normals.error());
    out.normals = std::move(*normals);
  }
  if (primitive.indices >= 0) {
    auto indices = reader_.indices(primitive.indices, where);
    if (!indices) return tl::unexpected<Problem>(indices.error());
    out.indices = std::move(*indices);
  } else {
    for (std::uint32_t i = 0; i < out.positions.size(); ++i) out.indices.push_back(i);
  }
  return out;
}

Result<void> Gatherer::add_primitive(const tinygltf::Primitive& primitive,
                                     const DracoPrimitive* draco, const Matrix& world,
                                     const std::string& where) {
  int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  if (mode < TINYGLTF_MODE_TRIANGLES || mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    ++skipped_;
    return {};
  }
  DecodedPrimitive data;
  if (draco != nullptr) {
    const auto bytes = reader_.view(draco->view, where);
    if (!bytes) return tl::unexpected<Problem>(bytes.error());
    const auto& all = document_.materials;
    const auto material = static_cast<std::size_t>(primitive.material);
    const int set =
        primitive.material < 0 || material >= all.size() ? 0 : all[material].coordinates;
    auto decoded = decode_draco(*bytes, *draco, set, where, limits_);
    if (!decoded) return tl::unexpected<Problem>(decoded.error());
    data = std::move(*decoded);
    check_draco_bounds(data, draco->accessor);
    mode = TINYGLTF_MODE_TRIANGLES;
  } else {
    auto read = read_primitive(primitive, where);
    if (!read) return tl::unexpected<Problem>(read.error());
    data = std::move(*read);
  }
  const std::size_t count = data.positions.size();
  // Count corners as they are read: a node that shows a mesh again costs its time again, even if
  // nothing is kept.
  corners_ += data.indices.size();
  if (count + out_.mesh.positions.size() > static_cast<std::size_t>(limits_.vertices) ||
      corners_ / 3 > static_cast<std::size_t>(limits_.triangles))
    return tl::unexpected(
        beyond_limit(where, "the file has more vertices or triangles",
                     std::to_string(limits_.vertices) + " vertices and " +
                         std::to_string(limits_.triangles) + " triangles",
                     "vertices or triangles",
                     "Export it with fewer triangles (100,000 show every throwing line)"));
  for (const std::uint32_t i : data.indices)
    if (i >= count)
      return unsound(where, "a triangle names vertex " + std::to_string(i) + " of " +
                                std::to_string(count) + ".");

  // A mirroring transform turns triangles inside out; swapping corners repairs that.
  const Vec3 a = column(world, 0), b = column(world, 1), c = column(world, 2), t = column(world, 3);
  const bool mirrored = dot(a, cross(b, c)) < 0.0;
  const Vec3 na = cross(b, c), nb = cross(c, a), nc = cross(a, b);  // inverse transpose, scaled
  const auto base = static_cast<std::uint32_t>(out_.mesh.positions.size());
  for (const auto& p : data.positions) {
    const Vec3 v = a * p[0] + b * p[1] + c * p[2] + t;
    const std::array<float, 3> at{static_cast<float>(v.x), static_cast<float>(v.y),
                                  static_cast<float>(v.z)};
    if (!std::isfinite(at[0]) || !std::isfinite(at[1]) || !std::isfinite(at[2]))
      return problem(where, "its node moves or scales it too far.",
                     "Apply the transforms in the modelling tool and export again.");
    out_.mesh.positions.push_back(at);
  }
  colors_.add(primitive, draco == nullptr ? nullptr : &data, count, reader_);
  const bool given = data.normals.size() == count;
  std::vector<Vec3> normals(count);
  for (std::size_t i = 0; given && i < count; ++i) {
    const auto& n = data.normals[i];
    normals[i] = (na * n[0] + nb * n[1] + nc * n[2]) * (mirrored ? -1.0 : 1.0);
  }
  const auto at = [&](std::uint32_t i) {
    const auto& p = out_.mesh.positions[base + i];
    return Vec3{p[0], p[1], p[2]};
  };
  std::size_t added = 0;
  for (auto corners : triangles_of(data.indices, mode)) {
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    if (mirrored) std::swap(corners[1], corners[2]);
    if (!given) {
      const Vec3 face = cross(at(corners[1]) - at(corners[0]), at(corners[2]) - at(corners[0]));
      for (const std::uint32_t i : corners) normals[i] += face;
    }
    out_.mesh.triangles.push_back({base + corners[0], base + corners[1], base + corners[2]});
    ++added;
  }
  for (const Vec3& n : normals) {
    const double size = length(n);
    const Vec3 u = size > 0.0 && std::isfinite(size) ? n * (1.0 / size) : Vec3{0, 1, 0};
    out_.mesh.normals.push_back(
        {static_cast<float>(u.x), static_cast<float>(u.y), static_cast<float>(u.z)});
  }
  if (primitive.material >= 0 &&
      static_cast<std::size_t>(primitive.material) < triangles_of_material_.size())
    triangles_of_material_[static_cast<std::size_t>(primitive.material)] += added;
  return {};
}

void Gatherer::check_draco_bounds(const DecodedPrimitive& data, int accessor) {
  if (data.positions.empty()) return;
  std::array<double, 3> low, high;
  low.fill(1e300);
  high.fill(-1e300);
  for (const auto& p : data.positions)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min<double>(low[k], p[k]);
      high[k] = std::max<double>(high[k], p[k]);
    }
  reader_.check_bounds(accessor, low, high, 0.02);  // Draco rounds positions
}

Result<GltfModel> Gatherer::result() {
  if (out_.mesh.triangles.empty())
    return problem(document_.name, "there is no surface in it.",
                   "Export the vessel's mesh as triangles.");
  out_.credit = document_.credit;
  out_.warnings = document_.warnings;
  out_.coloring = colors_.finish(reader_, out_.warnings);
  for (std::string& warning : reader_.warnings()) out_.warnings.push_back(std::move(warning));
  if (skipped_ > 0)
    out_.warnings.push_back(std::to_string(skipped_) + " sets of points or lines were left out.");
  const auto largest =
      std::max_element(triangles_of_material_.begin(), triangles_of_material_.end());
  if (largest != triangles_of_material_.end() && *largest > 0) {
    const auto index = static_cast<std::size_t>(largest - triangles_of_material_.begin());
    out_.colored = !document_.materials[index].textured;
    if (out_.colored) out_.base_color = document_.materials[index].factor;
  }
  return std::move(out_);
}

}  // namespace

Result<GltfModel> read_gltf(const std::filesystem::path& file,
                            const settings::ReaderLimits& limits) {
  const auto document = open_gltf(file, limits);
  if (!document) return tl::unexpected<Problem>(document.error());
  Gatherer gatherer(*document, limits);
  if (auto walked = gatherer.walk_scene(); !walked) return tl::unexpected<Problem>(walked.error());
  return gatherer.result();
}

}  // namespace onggi::content
