#pragma once

#include <filesystem>

#include "kiosk/ground/files/output.h"

namespace onggi::files {

/// True if the bytes of `file` are of `kind`, whatever its name, so that a new file of that kind
/// may replace it. An empty file is of every kind. A glTF does not count as JSON here, because a
/// report in its place would destroy a vessel. False if it cannot be read or has more than 64 MiB
/// of JSON. Allocates; any thread.
bool is_of_kind(const std::filesystem::path& file, Output::Kind kind);

/// False if the name of `file` ends as files of another kind do (".gif" for a picture, ".csv" for
/// JSON), in whatever case. True for endings that are not known, and for none. Reads nothing.
bool name_agrees(const std::filesystem::path& file, Output::Kind kind);

/// True if a picture of this name is drawn as an SVG: it ends in ".svg" or ".SVG".
bool is_svg(const std::filesystem::path& file);

}  // namespace onggi::files
