#pragma once

#include <filesystem>

#include "kiosk/collection/content/gltf.h"

namespace onggi::content {

/// The endings of files that a vessel may come in, in small letters and with their dot.
bool is_mesh_ending(const std::string& ending);

/// Metres in a unit by the rules of the file's format: 1 for GLB and glTF, 0 where it has none.
double format_unit(const std::filesystem::path& file);

/// Reads a vessel's file by its ending: GLB and glTF as read_gltf() does, OBJ, PLY and STL by the
/// helper program onggi-mesh, which lies beside this one and has its own memory and time. The same
/// limits hold. Blocks; starts a process. Allocates.
Result<GltfModel> read_mesh_file(const std::filesystem::path& file,
                                 const settings::ReaderLimits& limits = {});

}  // namespace onggi::content
