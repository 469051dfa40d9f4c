#pragma once

#include <filesystem>

#include "engine/base/result.h"
#include "kiosk/collection/content/gltf_credit.h"
#include "kiosk/collection/settings/reader_limits.h"

namespace onggi::content {

/// A document that a museum publishes beside a scan: a IIIF Presentation manifest (4.0, a Scene;
/// 3.0, a Canvas or `rendering`) or a Smithsonian document (Voyager's SVX, document.json).
struct ScanDocument {
  std::filesystem::path model;  ///< The scan, a regular file beneath the document's folder.
  double unit = 0.0;            ///< Metres in one of its units; 0: not given.
  GltfCredit credit;            ///< Credit and labels from the document.
};

/// True if the file name ends in .json.
bool is_document_ending(const std::filesystem::path& file);

/// True for a JSON file that is one of these documents. Reads at most 64 MiB, and only files that
/// end in .json.
bool is_scan_document(const std::filesystem::path& file);

/// Reads the document within the JSON limits of a glTF. The model must be beneath the document's
/// folder, by a relative name. For a web address, only a file of that name beside the document is
/// used, because the kiosk opens nothing from a network. Of several qualities, the finest that
/// exists is used. Problem for anything else: no model, several vessels, a missing model. The
/// document's rotation is ignored: the upright direction is found from the shape.
Result<ScanDocument> read_scan_document(const std::filesystem::path& file,
                                        const settings::ReaderLimits& limits);

}  // namespace onggi::content
