#pragma once

#include <cstddef>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kiosk/ground/files/read_file.h"
#include "kiosk/picture/view/image.h"

namespace onggi::souvenir {

/// A pot for the gallery, without anything about its visitor.
struct SmallPot {
  view::Image picture;
  std::string vessel;  ///< The id of the vessel that it answers.
  int stars = 0;       ///< Of 5.
};

/// Its facts as pot.txt, a line each.
std::string text_of(const SmallPot& pot);

/// A kept pot on the disk.
struct KeptPot {
  std::string visit;     ///< Its folder.
  std::string vessel;    ///< As SmallPot's.
  int stars = 0;         ///< 0..5
  std::string revision;  ///< Changes when its picture is written again.
  friend bool operator==(const KeptPot&, const KeptPot&) = default;
};

/// The pots kept in `folder` on the local day of `now`, by the dates in their folders' names,
/// newest first, at most `most`. Left out are pots without a picture or with an invalid pot.txt,
/// and those being written or removed. Links are not followed. Blocks on the disk; any thread.
std::vector<KeptPot> pots_of_today(const std::filesystem::path& folder, std::time_t now,
                                   std::size_t most);

/// The bytes of a pot's picture; nothing if it is gone, or larger than any that onggi writes.
std::optional<files::Bytes> picture_of(const std::filesystem::path& folder, const KeptPot& pot);

}  // namespace onggi::souvenir
