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
#include "kiosk/collection/decoration/starts.h"
#include "kiosk/collection/settings/reader_limits.h"

namespace onggi::content {

/// The label in one language.
struct Label {
  std::string title;      ///< "Moon jar"
  std::string culture;    ///< "Korea, Joseon dynasty"
  std::string date;       ///< "18th century"
  std::string made;       ///< How it was made, one sentence.
  std::string text;       ///< At most 100 words.
  std::string credit;     ///< The full credit line in this language; empty: Vessel::credit.
  std::string address{};  ///< The museum's page in this language, good (content/address.h), or "".
  std::string what{};     ///< What it is, in a few words: "A pharmacy jar".
};

/// A vessel on the shelf: the mesh for its picture, the profile for its outline and score.
struct Vessel {
  std::string id;              ///< Folder or file name without its ending.
  std::filesystem::path file;  ///< The GLB or glTF.
  std::string node;            ///< The node of that file; empty: the whole file.
  struct Node {
    std::string name;
    std::size_t triangles = 0;
  };
  std::vector<Node> nodes;              ///< The nodes of its surface.
  std::map<std::string, Label> labels;  ///< By language; may be empty for a bare file.
  GltfCredit given;                     ///< What the file says about itself.
  std::string credit, licence, source;
  bool built = false;  ///< It was built of coils, not thrown.
  /// The face of its makers' paddle, of PrintsDef::Face; nothing: that of the scene.
  std::optional<int> paddle;
  std::string way;  ///< Id of the way that visitors decorate it in; empty: the usual one.
  std::vector<std::string> glazes;  ///< Ids of its own glazes, which are offered first.
  /// Where its makers began, if it has a good decoration.toml.
  std::vector<decoration::Start> starts;
  std::string address;       ///< The museum's page, valid; a label may have its own.
  double true_height = 0.0;  ///< Metres, from the TOML's height or diameter; 0: not given.
  SizeFrom size_from = SizeFrom::file;
  TriangleMesh mesh;           ///< Upright: foot at y = 0, axis on y. Metres.
  LighterMesh turning;         ///< A reduced `mesh`, for a turning picture.
  ExtractedProfile extracted;  ///< Its profile in metres; its axis in the file's axes and units.
  double unit = 1.0;           ///< Metres in one unit of the file, as used.
  std::array<float, 3> color = kClayColor;  ///< Linear base colour for its picture,
  Coloring coloring;  ///< or, if there are any, the colours of `mesh`'s positions.

  /// The label in `language`, else in English, else one made from the file's name; with the
  /// vessel's address if the label has none.
  Label label(const std::string& language) const;
};

/// How to read a vessel's file. A pack's TOML overrides `node`; `up` overrides the TOML.
struct LoadOptions {
  std::string id;    ///< Id on the shelf; empty: the file's or folder's name.
  std::string node;  ///< Name or number of the node that is the vessel; empty: the whole file.
  std::optional<Vec3> up;  ///< In the file's axes; absent: found from the shape.
  settings::ReaderLimits limits;
  bool for_screen = false;  ///< Its surface is reduced to what a frame can draw (screen_model.h).
};

/// Loads one vessel: a pack folder, or a GLB/glTF file. If a file holds several separate objects
/// and none is named, the Problem lists them.
Result<Vessel> load_vessel(const std::filesystem::path& path, const LoadOptions& options = {});

/// Loads every object of a file that is a vessel, each with its own id ("tea_set_cup"). At least
/// one, or a Problem.
Result<std::vector<Vessel>> load_vessels(const std::filesystem::path& path,
                                         const LoadOptions& options = {});

}  // namespace onggi::content
