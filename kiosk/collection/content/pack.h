#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/collection/content/vessel.h"

namespace onggi::content {

/// A vessel.toml: what a curator writes about a vessel (kiosk/docs/add_a_vessel.md).
struct Pack {
  bool unfinished = false;  ///< Visitors do not see it yet.
  std::string drawing;      ///< A file beside it; empty: none.
  std::string decoration;   ///< A file beside it, of which its colours were made; empty: none.
  bool built = false;       ///< It was built of coils, not thrown.
  /// The face of its makers' paddle, of PrintsDef::Face; nothing: that of the scene.
  std::optional<int> paddle;
  std::string way;                  ///< Id of the way that visitors decorate it in; empty: usual.
  std::vector<std::string> glazes;  ///< Ids of its own glazes, which are offered first.
  double true_height = 0.0, true_diameter = 0;  ///< Metres; 0: not given.
  double unit = 0.0;                            ///< Metres in one unit of the mesh; 0: not given.
  std::optional<Vec3> up;                       ///< In the mesh's axes.
  std::string node;                             ///< The node of the file; empty: the whole file.
  std::string institution, accession, source, credit, licence;
  std::string address;                        ///< The museum's page about it; empty: none.
  std::optional<std::array<float, 3>> color;  ///< Linear.
  std::map<std::string, Label> labels;

  /// The credit line as it is printed: institution, accession number, credit.
  std::string credit_line() const;
};

/// The axis that `up = "-z"` or `--up -z` names; nothing for other words.
std::optional<Vec3> axis_called(const std::string& name);

struct PackRead {
  Pack pack;
  std::vector<Problem> problems;  ///< Faults that keep it off the shelf, with line and column.
  std::vector<Problem> advice;    ///< Faults that should be fixed but do not keep it off the shelf.
  int keys_checked = 0;
};
/// Reads a pack. `languages`: the label should exist in all of them, else there is advice; if
/// empty, one language is enough.
PackRead read_pack(const std::filesystem::path& toml,
                   const std::vector<std::string>& languages = {});

/// True if the pack in `folder` says that visitors should not see it yet.
bool is_unfinished(const std::filesystem::path& folder);

/// The licence of an imported pack if the file names none; `onggi check` then asks for a real one.
inline constexpr const char* kLicenceNotKnown = "not known";

}  // namespace onggi::content
