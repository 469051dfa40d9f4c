#pragma once

#include <filesystem>

#include "engine/base/result.h"
#include "kiosk/collection/content/gltf_credit.h"
#include "kiosk/collection/settings/reader_limits.h"

namespace onggi::content {

/// What a museum publishes beside a scan: a IIIF Presentation manifest (4.0, a Scene; 3.0, a Canvas
/// or `rendering`) or a Smithsonian document (Voyager's SVX, document.json).
struct ScanDocument {
  std::filesystem::path model;  ///< The scan, a regular file beneath the document's folder.
  double unit = 0.0;            ///< Metres in one of its units; 0: the document does not say.
  GltfCredit credit;            ///< What the document says of the vessel.
};

/// Does the file's name end as a document's does, .json?
bool is_document_ending(const std::filesystem::path& file);

/// Is `file` a JSON file that says it is one of those? Reads no more than 64 MiB, and nothing that
/// does not end in .json.
bool is_scan_document(const std::filesystem::path& file);

/// Reads it, within the limits of a glTF's JSON. The model lies beneath its own folder, by a
/// relative name; of an address on the web only the file of that name beside the document is taken,
/// since the kiosk opens nothing of a network. Of several qualities the finest that is there.
/// Problem, with its remedy, for anything else: no model, several vessels, a model that is not
/// there. The document's turning of the model is not used: which way is up is found from the shape.
Result<ScanDocument> read_scan_document(const std::filesystem::path& file,
                                        const settings::ReaderLimits& limits);

}  // namespace onggi::content
