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
  std::map<int, int> places;                   ///< The same, of TEXCOORD_n by n.
  std::set<int> normalized;  ///< The n whose accessor says that whole numbers are shares.
  int accessor = -1;         ///< That declares the positions' bounds.
};

/// What a material says of its colour, and where its picture lies on the surface.
struct GltfMaterial {
  std::array<float, 3> factor{1, 1, 1};  ///< Linear, 0..1.
  bool textured = false;                 ///< Its colour is a picture,
  int picture = -1;                      ///< this one of GltfDocument::pictures; -1: none it has.
  int coordinates = 0;                   ///< TEXCOORD_n
  std::array<double, 6> placed{1, 0, 0, 0, 1, 0};  ///< Rows that take (u, v, 1) into the picture.
  Coloring::Wrap across = Coloring::Wrap::repeat, down = Coloring::Wrap::repeat;
};

/// What a file brings beyond these is noted, and not read.
constexpr std::size_t kMostPictures = 64;

/// A picture, still as it was written.
struct GltfPicture {
  std::string name;  ///< The file's for it.
  int view = -1;     ///< Its buffer view; -1: it is in `bytes`.
  std::span<const unsigned char> bytes;
  std::string fault;  ///< Why it cannot be had; "" where it can.
};

/// A glTF 2.0 file whose JSON has been measured, whose required extensions are known, whose buffers
/// are in memory, and which tinygltf has parsed. Indices and ranges inside are still unchecked.
struct GltfDocument {
  GltfDocument() = default;
  GltfDocument(GltfDocument&&) = default;  // a copy's buffers would be the original's
  GltfDocument& operator=(GltfDocument&&) = default;

  std::string name;  ///< For Problems.
  std::shared_ptr<tinygltf::Model> model;
  files::Bytes file;                 ///< The file itself,
  std::vector<files::Bytes> beside;  ///< and those that it names.
  /// Of these, what each buffer has; empty for a meshopt fallback.
  std::vector<std::span<const unsigned char>> buffers;
  std::map<int, MeshoptView> meshopt;
  std::map<std::pair<int, int>, DracoPrimitive> draco;  ///< By (mesh, primitive).
  std::vector<GltfMaterial> materials;
  std::vector<GltfPicture> pictures;  ///< That a material's colour is.
  struct Bounds {
    std::array<double, 3> low{}, high{};
  };
  std::map<int, Bounds> bounds;  ///< Declared, by accessor, in the numbers as they are stored.
  GltfCredit credit;
  std::vector<std::string> warnings;
};

/// Only geometry and nodes are handed on: images, textures, skins, animations, cameras and extras
/// are cut out before tinygltf sees the JSON, and it opens no file of its own.
Result<GltfDocument> open_gltf(const std::filesystem::path& file,
                               const settings::ReaderLimits& limits);

}  // namespace onggi::content
