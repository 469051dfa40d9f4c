#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/profile/extraction.h"
#include "engine/profile/mesh.h"
#include "kiosk/collection/content/coloring.h"
#include "kiosk/collection/content/gltf_credit.h"
#include "kiosk/collection/content/lighter_mesh.h"
#include "kiosk/collection/content/true_size.h"
#include "kiosk/collection/settings/reader_limits.h"

namespace onggi::content {

/// What the label says, in one language.
struct Label {
  std::string title;      ///< "Moon jar"
  std::string culture;    ///< "Korea, Joseon dynasty"
  std::string date;       ///< "18th century"
  std::string made;       ///< How it was made, one sentence.
  std::string text;       ///< At most 100 words.
  std::string credit;     ///< The whole credit line in this language; empty: Vessel::credit.
  std::string address{};  ///< The museum's page in this language, good (content/address.h), or "".
};

/// A vessel on the shelf: the mesh for its picture, the profile for its outline and score.
struct Vessel {
  std::string id;              ///< Folder or file name, without its ending.
  std::filesystem::path file;  ///< The GLB or glTF.
  std::string node;            ///< The object of that file; empty: all of it.
  struct Node {
    std::string name;
    std::size_t triangles = 0;
  };
  std::vector<Node> nodes;              ///< That carry its surface.
  std::map<std::string, Label> labels;  ///< By language; may be empty for a bare file.
  GltfCredit given;                     ///< What the file says of itself.
  std::string credit, licence, source;
  std::string address;       ///< The museum's page, good; a label may have one of its own.
  double true_height = 0.0;  ///< Metres, by the TOML's height or diameter; 0: not told.
  SizeFrom size_from = SizeFrom::file;
  TriangleMesh mesh;           ///< Upright: foot at y = 0, axis on y. Metres.
  LighterMesh turning;         ///< Of it, for a picture that turns.
  ExtractedProfile extracted;  ///< Its profile in metres; the axis as the file has it, file units.
  double unit = 1.0;           ///< Metres that one unit of the file was taken for.
  std::array<float, 3> color = kClayColor;  ///< Linear base colour for its picture,
  Coloring coloring;  ///< and the colours of `mesh`'s positions, in its stead where there are any.

  /// The label in `language`, else English, else one made of the file's name; with the vessel's
  /// address where it has none of its own.
  Label label(const std::string& language) const;
};

/// How a vessel's file is to be read. What a pack's TOML says goes before `node`, and `up` before
/// what it says.
struct LoadOptions {
  std::string id;    ///< On the shelf; empty: the file's or folder's name.
  std::string node;  ///< Name or number of the node that is the vessel; empty: all of the file.
  std::optional<Vec3> up;  ///< In the file's axes; absent: decided from the shape.
  settings::ReaderLimits limits;
};

/// One vessel: a pack folder, or a GLB/glTF file. A file of several objects that stand apart is a
/// Problem that lists them, unless one is named.
Result<Vessel> load_vessel(const std::filesystem::path& path, const LoadOptions& options = {});

/// The same, but every object of a file of several that is a vessel, each with its own id
/// ("tea_set_cup"). At least one, or a Problem.
Result<std::vector<Vessel>> load_vessels(const std::filesystem::path& path,
                                         const LoadOptions& options = {});

}  // namespace onggi::content
