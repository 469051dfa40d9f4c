#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/descriptor.h"

namespace onggi::files {

using Bytes = std::vector<unsigned char>;

/// Why a file was not read. The caller writes the Problem, because it knows what the file was for.
struct ReadFault {
  enum class Kind {
    missing,     ///< No file has this name.
    closed,      ///< It cannot be opened.
    folder,      ///< It is a folder.
    special,     ///< It is a pipe, a device or the like.
    too_large,   ///< It is larger than was allowed.
    unreadable,  ///< It was opened, and reading it failed.
    outside,     ///< Its name leads out of the folder (read_beneath() only).
    link,        ///< A symbolic link is on the way (read_beneath() only).
  };
  Kind kind = Kind::missing;
  std::size_t size = 0;  ///< Bytes, where it is too large.
  std::string reason;    ///< The system's own words, if any: "Permission denied".
};

/// The whole of a regular file of at most `most` bytes. Never waits: a pipe without a writer is a
/// fault. Allocates; any thread.
tl::expected<Bytes, ReadFault> read_file(const std::filesystem::path& file, std::size_t most);

/// The same for `uri` (percent-encoded, relative) beneath `folder` only: absolute paths, ".." and
/// symbolic links are refused.
tl::expected<Bytes, ReadFault> read_beneath(const std::filesystem::path& folder,
                                            const std::string& uri, std::size_t most);

/// That regular file, opened for a reader who takes a piece at a time; the same rules apply.
tl::expected<Descriptor, ReadFault> open_beneath(const std::filesystem::path& folder,
                                                 const std::string& uri);

/// The path of that regular file, for a reader that opens it itself; the same rules apply.
tl::expected<std::filesystem::path, ReadFault> find_beneath(const std::filesystem::path& folder,
                                                            const std::string& uri);

}  // namespace onggi::files
