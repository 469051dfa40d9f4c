#pragma once

#include <map>
#include <string>

namespace onggi::content {

/// Credit and licence that a glTF file names: from asset.copyright, asset.extras (as Sketchfab
/// writes it) and KHR_xmp_json_ld (Dublin Core, XMP rights, Creative Commons). Fields that the file
/// does not give are empty.
struct GltfCredit {
  std::string title, creator, copyright, licence, source, date, description;
  std::map<std::string, std::string> titles;  ///< By language; of a museum's document alone, as are
  std::string institution, accession, culture;
  std::string address;  ///< The owner's page about it, valid (content/address.h), or "".

  /// "“pot” by vivikeram. Copyright 2020 ...", ready to print; "" if nothing is known.
  std::string line() const;
  /// `first`, with its empty fields filled from this.
  GltfCredit after(const GltfCredit& first) const;
};

/// The short name ("CC-BY-4.0", "CC0-1.0") of a Creative Commons licence that `text` names by name
/// or address; "" if it names none.
std::string licence_named_in(const std::string& text);

}  // namespace onggi::content
