#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/collection/content/vessel.h"

namespace onggi::content {

/// A vessel.toml: what a curator writes about a vessel (kiosk/docs/curators.md).
struct Pack {
  std::string drawing;                          ///< Beside it; empty: none.
  double true_height = 0.0, true_diameter = 0;  ///< Metres; 0: not given.
  double unit = 0.0;                            ///< Metres in one unit of the mesh; 0: not given.
  std::optional<Vec3> up;                       ///< In the mesh's axes.
  std::string node;                             ///< The object of the file; empty: all of it.
  std::string institution, accession, source, credit, licence;
  std::string address;                        ///< The museum's page on it; empty: none.
  std::optional<std::array<float, 3>> color;  ///< Linear.
  std::map<std::string, Label> labels;

  /// The credit line as it is printed: institution, accession number, credit.
  std::string credit_line() const;
};

/// The axis that `up = "-z"` and `--up -z` name; nothing for any other word than those six.
std::optional<Vec3> axis_called(const std::string& name);

struct PackRead {
  Pack pack;
  std::vector<Problem> problems;  ///< What keeps it off the shelf, with line and column.
  std::vector<Problem> advice;    ///< What should be put right, and does not.
  int keys_checked = 0;
};
/// Reads it; `languages` are those that its label has to be in, as far as advice goes: none given,
/// one of any language will do.
PackRead read_pack(const std::filesystem::path& toml,
                   const std::vector<std::string>& languages = {});

/// What an imported pack says where the file names no licence; `onggi check` asks for a real one.
inline constexpr const char* kLicenceNotKnown = "not known";

}  // namespace onggi::content
