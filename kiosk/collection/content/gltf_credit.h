#pragma once

#include <map>
#include <string>

namespace onggi::content {

/// Whom a glTF file says to thank, and under what licence: from asset.copyright, asset.extras (as
/// Sketchfab writes it) and KHR_xmp_json_ld (Dublin Core, XMP rights, Creative Commons). Empty
/// where the file is silent.
struct GltfCredit {
  std::string title, creator, copyright, licence, source, date, description;
  std::map<std::string, std::string> titles;  ///< By language; of a museum's document alone, as are
  std::string institution, accession, culture;
  std::string address;  ///< The page on it that its owner names, good (content/address.h), or "".

  /// "“pot” by vivikeram. Copyright 2020 ..." as it may be printed; "" where nothing is known.
  std::string line() const;
  /// What `first` says, and where it is silent this.
  GltfCredit after(const GltfCredit& first) const;
};

/// The short name of a Creative Commons licence that `text` names by name or address
/// ("CC-BY-4.0", "CC0-1.0"); "" where it names none.
std::string licence_named_in(const std::string& text);

}  // namespace onggi::content
