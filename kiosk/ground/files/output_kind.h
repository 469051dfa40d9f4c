#pragma once

#include <filesystem>

#include "kiosk/ground/files/output.h"

namespace onggi::files {

/// Whether what `file` holds is of `kind`, by its bytes, whatever its name: then another of its
/// kind may take its place. An empty file is of every kind. A glTF is no JSON here, though it is
/// written in it: a report in its place would be a vessel lost. False where it cannot be read or
/// is longer than 64 MiB of JSON. Allocates; any thread.
bool is_of_kind(const std::filesystem::path& file, Output::Kind kind);

}  // namespace onggi::files
