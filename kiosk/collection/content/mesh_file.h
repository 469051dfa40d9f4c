#pragma once

#include <filesystem>

#include "kiosk/collection/content/gltf.h"

namespace onggi::content {

/// True for the endings of vessel files, in lower case with their dot.
bool is_mesh_ending(const std::string& ending);

/// Metres in one unit by the rules of the file's format: 1 for GLB and glTF, 0 if the format has no
/// unit.
double format_unit(const std::filesystem::path& file);

/// Reads a vessel's file by its ending: GLB and glTF with read_gltf(); OBJ, PLY and STL with the
/// helper program onggi-mesh beside this program, which has its own memory and time. The same
/// limits apply. Blocks; starts a process. Allocates.
Result<GltfModel> read_mesh_file(const std::filesystem::path& file,
                                 const settings::ReaderLimits& limits = {});

}  // namespace onggi::content
