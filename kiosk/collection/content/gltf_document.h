#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/content/coloring.h"
#include "kiosk/collection/content/gltf_credit.h"
#include "kiosk/collection/settings/reader_limits.h"
#include "kiosk/ground/files/read_file.h"

namespace tinygltf {
class Model;
}

namespace onggi::content {

/// EXT_meshopt_compression of one buffer view.
struct MeshoptView {
  std::size_t buffer = 0, offset = 0, length = 0, stride = 0, count = 0;
  std::string mode, filter;
};

/// KHR_draco_mesh_compression of one primitive.
struct DracoPrimitive {
  int view = -1;
  int position = -1, normal = -1, color = -1;  ///< Attribute ids inside the Draco data.
  std::map<int, int> places;                   ///< The same for TEXCOORD_n, by n.
  std::set<int> normalized;  ///< The n whose accessor says that integers are normalised.
  int accessor = -1;         ///< The accessor that declares the positions' bounds.
};

/// The colour of a material, and how its picture lies on the surface.
struct GltfMaterial {
  std::array<float, 3> factor{1, 1, 1};  ///< Linear, 0..1.
  bool textured = false;                 ///< The colour is a picture:
  int picture = -1;     ///< its index in GltfDocument::pictures; -1: it is missing.
  int coordinates = 0;  ///< TEXCOORD_n
  std::array<double, 6> placed{1, 0, 0, 0, 1, 0};  ///< Rows that map (u, v, 1) into the picture.
  Coloring::Wrap across = Coloring::Wrap::repeat, down = Coloring::Wrap::repeat;
};

/// Pictures beyond this number are noted but not read.
constexpr std::size_t kMostPictures = 64;

/// A picture in its encoded form.
struct GltfPicture {
  std::string name;  ///< Its name in the file.
  int view = -1;     ///< Its buffer view; -1: it is in `bytes`.
  std::span<const unsigned char> bytes;
  std::string fault;  ///< Why it cannot be read; "" if it can.
};

/// A glTF 2.0 file after these checks: JSON size measured, required extensions known, buffers in
/// memory, parsed by tinygltf. Indices and ranges inside are still unchecked.
struct GltfDocument {
  GltfDocument() = default;
  GltfDocument(GltfDocument&&) = default;  // a copy's spans would point into the original
  GltfDocument& operator=(GltfDocument&&) = default;

  std::string name;  ///< For Problems.
  std::shared_ptr<tinygltf::Model> model;
  files::Bytes file;                 ///< The file itself
  std::vector<files::Bytes> beside;  ///< and the files that it names.
  /// The bytes of each buffer; empty for a meshopt fallback.
  std::vector<std::span<const unsigned char>> buffers;
  std::map<int, MeshoptView> meshopt;
  std::map<std::pair<int, int>, DracoPrimitive> draco;  ///< By (mesh, primitive).
  std::vector<GltfMaterial> materials;
  std::vector<GltfPicture> pictures;  ///< The pictures that materials use as colour.
  struct Bounds {
    std::array<double, 3> low{}, high{};
  };
  std::map<int, Bounds> bounds;  ///< Declared bounds by accessor, in stored numbers.
  GltfCredit credit;
  std::vector<std::string> warnings;
};

/// The Problem of a file whose own numbers contradict each other.
tl::unexpected<Problem> unsound(const std::string& where, std::string what);

/// Passes only geometry and nodes to tinygltf: images, textures, skins, animations, cameras and
/// extras are removed before, so tinygltf opens no file.
Result<GltfDocument> open_gltf(const std::filesystem::path& file,
                               const settings::ReaderLimits& limits);

}  // namespace onggi::content
