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

/// A pot as the gallery shows it, to be kept. Nothing of who it was.
struct SmallPot {
  view::Image picture;
  std::string vessel;  ///< The id of the vessel that it answers.
  int stars = 0;       ///< Of 5.
};

/// What is said of it, as pot.txt: a line each.
std::string text_of(const SmallPot& pot);

/// A pot that was kept, as it lies on the disk.
struct KeptPot {
  std::string visit;     ///< Its folder.
  std::string vessel;    ///< As SmallPot's.
  int stars = 0;         ///< 0..5
  std::string revision;  ///< Another one where its picture was written anew.
  friend bool operator==(const KeptPot&, const KeptPot&) = default;
};

/// The pots that were kept in `folder` on the local day of `now`, by the dates in their folders'
/// names, newest first, `most` at the most. One without a picture, or whose pot.txt says nothing
/// good, is left out; and so is one that is being written or removed. Links are not followed.
/// Blocks on the disk; any thread.
std::vector<KeptPot> pots_of_today(const std::filesystem::path& folder, std::time_t now,
                                   std::size_t most);

/// The bytes of a pot's picture; nothing where it is gone, or larger than any that was written.
std::optional<files::Bytes> picture_of(const std::filesystem::path& folder, const KeptPot& pot);

}  // namespace onggi::souvenir
