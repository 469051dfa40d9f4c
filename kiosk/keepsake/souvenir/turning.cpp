#include "kiosk/keepsake/souvenir/turning.h"

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/shared_folder.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace onggi::souvenir {
namespace {

namespace fs = std::filesystem;

constexpr int kFewest = 4;  // if all are too many, use every n-th picture, up to this n

/// Every `nth` of its pictures, with the same duration.
encoding::Turning sparser(const encoding::Turning& all, int nth) {
  encoding::Turning some{all.width, all.height, (all.frames + nth - 1) / nth, all.seconds, {}};
  const std::size_t size = all.rgba.size() / static_cast<std::size_t>(std::max(all.frames, 1));
  for (int n = 0; n < all.frames; n += nth) {
    const auto from = all.rgba.begin() + static_cast<std::ptrdiff_t>(size) * n;
    some.rgba.insert(some.rgba.end(), from, from + static_cast<std::ptrdiff_t>(size));
  }
  return some;
}

}  // namespace

Result<std::vector<std::byte>> turning_picture(const encoding::Turning& turning,
                                               const encoding::Caption& caption, std::size_t most) {
  auto gif = encoding::encode(turning, caption);
  for (int nth = 2; gif && gif->size() > most && nth <= kFewest; nth *= 2)
    gif = encoding::encode(sparser(turning, nth), caption);
  if (gif && gif->size() > most)
    return problem("the turning picture",
                   "It has " + std::to_string(gif->size()) + " bytes, and " + std::to_string(most) +
                       " are allowed.",
                   "Report it with the glaze's name: its surface is too busy.", 1);
  return gif;
}

Result<fs::path> add_turning(const fs::path& visit, std::span<const std::byte> gif,
                             const KeepsakeLimits& limits) {
  std::error_code error;
  if (fs::symlink_status(visit, error).type() != fs::file_type::directory)
    return problem(visit.string(), "The keepsake was deleted before its turning picture was made.",
                   "Nothing needs doing: somebody or the quota deleted it.", 1);
  // Made beside the visit, under a name that deleting the visit removes too.
  PartialFolder making(fs::path(visit) += kPartial);
  if (!fs::create_directory(making.path(), error)) {
    const fs::path there = making.path();
    making.keep();
    return tl::unexpected(files::disk_problem(there, "make", error ? error.value() : EEXIST));
  }
  files::share_as_above(making.path());
  if (auto written = files::write_durably(making.path() / kTurning, gif); !written)
    return tl::unexpected(written.error());
  if (auto moved = files::rename_durably(making.path() / kTurning, visit / kTurning); !moved)
    return tl::unexpected(moved.error());
  // This picture is saved even if others cannot be tidied.
  (void)tidy(visit.parent_path(), limits, visit.filename().string());
  return visit / kTurning;
}

}  // namespace onggi::souvenir
