#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "kiosk/ground/files/read_file.h"

namespace onggi::content {

/// Reads a vessel's file with files::read_file(); its Problems are worded for curators.
Result<files::Bytes> read_vessel_file(const std::filesystem::path& file, std::size_t most);

/// Reads a file that the vessel's file `name` asks for, with files::read_beneath(); the same
/// Problems.
Result<files::Bytes> read_vessel_file_beneath(const std::filesystem::path& folder,
                                              const std::string& uri, std::size_t most,
                                              const std::string& name);

/// The path of that file, for a reader that opens it itself; the same rules apply.
Result<std::filesystem::path> find_vessel_file_beneath(const std::filesystem::path& folder,
                                                       const std::string& uri,
                                                       const std::string& name);

}  // namespace onggi::content
