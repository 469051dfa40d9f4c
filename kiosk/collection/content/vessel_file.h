#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "kiosk/ground/files/read_file.h"

namespace onggi::content {

/// A file beyond a limit of the exhibit's [reader]: `what` it has, the `limit`, its `key` there,
/// and what makes the file smaller.
Problem beyond_limit(const std::string& where, const std::string& what, const std::string& limit,
                     const std::string& key,
                     const std::string& smaller = "Export the vessel with fewer triangles");

/// Reads a vessel's file with files::read_file(); its Problems are worded for curators. `key`: of
/// the limit `most`.
Result<files::Bytes> read_vessel_file(const std::filesystem::path& file, std::size_t most,
                                      const std::string& key = "file_mb");

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
