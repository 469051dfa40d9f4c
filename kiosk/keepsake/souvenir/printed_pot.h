#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/descriptor.h"
#include "kiosk/keepsake/souvenir/stl.h"

namespace onggi::souvenir {

/// What a visit's STL is made of: its relief where that is whole and of the visit's own pot, else
/// its model, without what was cut and laid on.
struct PrintedPot {
  files::Descriptor file;  ///< That file.
  StlOfPot stl;
  /// Why its relief was not taken, for the staff; nothing if it was, or if the visit has none.
  std::optional<Problem> remark;
};

/// Of the visit in the folder `visit` within `keepsakes`; follows no link, waits for no pipe.
/// Nothing: there is no model of ours. Blocks on the disk: it reads the whole relief and the first
/// 64 KiB of the model, about 1 ms. Any thread.
std::optional<PrintedPot> printed_pot(const std::filesystem::path& keepsakes,
                                      const std::string& visit);

/// The whole STL of a visit.
struct PrintedStl {
  std::vector<std::byte> bytes;
  std::optional<Problem> remark;  ///< PrintedPot's.
};
/// Of the visit in the folder `visit`. Problem, exit 2: there is no pot of ours.
Result<PrintedStl> stl_of_visit(const std::filesystem::path& visit);

}  // namespace onggi::souvenir
