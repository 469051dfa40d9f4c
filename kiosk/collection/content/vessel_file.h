#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "kiosk/ground/files/read_file.h"

namespace onggi::content {

/// files::read_file() of a vessel's file; what keeps it from being read in words for its curator.
Result<files::Bytes> read_vessel_file(const std::filesystem::path& file, std::size_t most);

/// files::read_beneath() of what the vessel's file `name` asks for; the same.
Result<files::Bytes> read_vessel_file_beneath(const std::filesystem::path& folder,
                                              const std::string& uri, std::size_t most,
                                              const std::string& name);

/// Where that file lies, for a reader of its own; by the same rules.
Result<std::filesystem::path> find_vessel_file_beneath(const std::filesystem::path& folder,
                                                       const std::string& uri,
                                                       const std::string& name);

}  // namespace onggi::content
