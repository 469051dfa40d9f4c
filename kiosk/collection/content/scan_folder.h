#pragma once

#include <filesystem>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/settings/reader_limits.h"

namespace onggi::content {

/// The scans in a folder, by their paths beneath it, in the order of their names.
struct FolderScans {
  /// IIIF manifests and Smithsonian documents whose scan is there (read_scan_document()).
  std::vector<std::filesystem::path> documents;
  std::vector<std::filesystem::path> meshes;  ///< GLB, glTF, OBJ, PLY and STL files.
  std::vector<Problem> unusable;              ///< Of documents that the kiosk knows and cannot use.

  /// What a vessel can be made of: the documents, else the meshes. Where it has several, somebody
  /// has to choose.
  const std::vector<std::filesystem::path>& offered() const {
    return documents.empty() ? meshes : documents;
  }
};

/// Looks for scans in `folder` and 16 folders deep beneath it. Links are not followed. Reads each
/// file that ends in .json. Allocates; any thread.
FolderScans scans_in(const std::filesystem::path& folder,
                     const settings::ReaderLimits& limits = {});

}  // namespace onggi::content
