#include "kiosk/collection/content/gltf_credit.h"

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "kiosk/collection/content/gltf_credit_reader.h"
#include "kiosk/collection/content/json_words.h"

namespace onggi::content {

namespace {

using json_words::first_of;
using json_words::list_of;
using json_words::member;
using json_words::page_of;
using json_words::within;
using nlohmann::json;

/// The packet that the asset names, else the first one.
const json* xmp_packet(const json& document) {
  constexpr const char* kXmp = "KHR_xmp_json_ld";
  const json& packets = list_of(within(within(document, "extensions"), kXmp), "packets");
  const json& named =
      within(within(within(within(document, "asset"), "extensions"), kXmp), "packet");
  const std::size_t index = named.is_number_unsigned() ? named.get<std::size_t>() : 0;
  return index < packets.size() ? &packets[index] : nullptr;
}

void fill(std::string& place, std::string words) {
  if (place.empty()) place = std::move(words);
}

}  // namespace

std::string licence_named_in(const std::string& text) {
  const std::string all = json_words::lower(text);
  if (all.find("publicdomain/zero") != std::string::npos || all.find("cc0") != std::string::npos)
    return "CC0-1.0";
  // "CC-BY-NC-4.0", "CC BY 4.0", "creativecommons.org/licenses/by-sa/3.0/"
  std::size_t at = all.find("creativecommons.org/licenses/");
  if (at != std::string::npos) {
    at += std::string("creativecommons.org/licenses/").size();
  } else {
    at = std::min(all.find("cc-by"), all.find("cc by"));
    if (at == std::string::npos) return "";
    at += 3;
  }
  std::string out = "CC";
  while (at < all.size()) {
    std::string part;
    while (at < all.size() && all[at] >= 'a' && all[at] <= 'z') part += all[at++];
    const bool known = part == "by" || part == "nc" || part == "sa" || part == "nd";
    if (!known) break;
    out += "-";
    for (const char c : part) out += static_cast<char>(c - 'a' + 'A');
    if (at < all.size() && (all[at] == '-' || all[at] == ' ' || all[at] == '/')) ++at;
  }
  if (out == "CC") return "";
  std::string version;
  while (at < all.size() && ((all[at] >= '0' && all[at] <= '9') || all[at] == '.'))
    version += all[at++];
  while (!version.empty() && version.back() == '.') version.pop_back();
  return version.size() == 3 ? out + "-" + version : out;
}

std::string GltfCredit::line() const {
  std::string out;
  if (!title.empty() && !creator.empty()) out = "“" + title + "” by " + creator;
  if (out.empty()) out = creator;
  // Skip the creator if the copyright already names them.
  if (!copyright.empty() && (out.empty() || copyright != creator))
    out += (out.empty() ? "" : ". ") + copyright;
  return out;
}

GltfCredit GltfCredit::after(const GltfCredit& first) const {
  GltfCredit out = first;
  for (const auto field :
       {&GltfCredit::title, &GltfCredit::creator, &GltfCredit::copyright, &GltfCredit::licence,
        &GltfCredit::source, &GltfCredit::date, &GltfCredit::description, &GltfCredit::institution,
        &GltfCredit::accession, &GltfCredit::culture, &GltfCredit::address})
    if ((out.*field).empty()) out.*field = this->*field;
  if (out.titles.empty() && first.title.empty()) out.titles = titles;
  return out;
}

GltfCredit read_credit(const json& document) {
  GltfCredit out;
  if (const json* xmp = xmp_packet(document)) {
    out.title = first_of(*xmp, {"dc:title", "dcterms:title", "xmp:nickname"});
    out.creator = first_of(*xmp, {"dc:creator", "dcterms:creator", "cc:attributionname",
                                  "xmprights:owner", "dc:publisher"});
    out.copyright = first_of(*xmp, {"dc:rights", "dcterms:rights"});
    out.licence = first_of(
        *xmp, {"dcterms:license", "cc:license", "xmprights:usageterms", "xmprights:webstatement"});
    out.source = first_of(*xmp, {"dc:source", "dcterms:source", "cc:attributionurl",
                                 "dc:identifier", "dcterms:identifier"});
    out.address = page_of(*xmp, {"foaf:page", "foaf:homepage", "schema:url", "dc:identifier",
                                 "dcterms:identifier", "dc:source", "dcterms:source"});
    out.date = first_of(*xmp, {"dcterms:created", "dc:date", "xmp:createdate"});
    out.description = first_of(*xmp, {"dc:description", "dcterms:description"});
  }
  if (const json* asset = member(document, "asset")) {
    if (const json* extras = member(*asset, "extras")) {
      fill(out.title, first_of(*extras, {"title", "name"}));
      fill(out.creator,
           first_of(*extras, {"author", "creator", "artist", "credit", "attribution"}));
      fill(out.licence, first_of(*extras, {"license", "licence", "rights"}));
      fill(out.source, first_of(*extras, {"source", "url", "link"}));
      fill(out.copyright, first_of(*extras, {"copyright"}));
      fill(out.date, first_of(*extras, {"date", "created"}));
      fill(out.description, first_of(*extras, {"description"}));
    }
    fill(out.copyright, first_of(*asset, {"copyright"}));
  }
  const std::string named = licence_named_in(out.licence);
  if (!named.empty()) out.licence = named;
  if (out.licence.empty()) out.licence = licence_named_in(out.copyright);
  return out;
}

}  // namespace onggi::content
