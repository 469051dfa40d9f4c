#include "kiosk/collection/content/scan_document.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/collection/content/gltf_container.h"
#include "kiosk/collection/content/json_words.h"
#include "kiosk/collection/content/mesh_file.h"
#include "kiosk/collection/content/vessel_file.h"

namespace onggi::content {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kVoyager = "application/si-dpo-3d.document+json";

/// The elements of a list; empty for anything else.
std::vector<const json*> each(const json* list) {
  std::vector<const json*> out;
  if (list != nullptr && list->is_array())
    for (const json& entry : *list) out.push_back(&entry);
  return out;
}

std::vector<const json*> each(const json& object, const char* key) {
  return each(json_words::member(object, key));
}

bool is_voyager(const json& doc) {
  return json_words::string_in(json_words::within(doc, "asset"), "type") == kVoyager;
}

bool is_manifest(const json& doc) {
  return json_words::string_in(doc, "type") == "Manifest" ||
         json_words::string_in(doc, "@type") == "sc:Manifest";
}

// ---- which file

/// A model that a document names.
struct Named {
  std::string name;    ///< An address or a relative name.
  std::string ending;  ///< From its media type if the name has no ending; may be empty.
  int rank = 0;        ///< Higher is finer.
  int vessel = 0;      ///< The same number for all models of one vessel in a IIIF Choice.
};

std::string ending_of_type(const std::string& format) {
  if (format == "model/gltf-binary" || format == "application/glb") return ".glb";
  if (format == "model/gltf+json") return ".gltf";
  if (format == "model/obj") return ".obj";
  if (format == "model/stl") return ".stl";
  return format == "model/ply" ? ".ply" : "";
}

std::string ending_of(const std::string& name) {
  return json_words::lower(fs::path(name.substr(0, name.find_first_of("?#"))).extension().string());
}

bool is_on_the_web(const std::string& name) {
  return name.find("://") != std::string::npos || name.rfind("//", 0) == 0;
}

/// The last part of an address, with its ending.
std::string file_of_address(const Named& named) {
  std::string name = named.name.substr(0, named.name.find_first_of("?#"));
  name = name.substr(name.find_last_of('/') + 1);
  if (!is_mesh_ending(ending_of(name))) name += named.ending.empty() ? ".glb" : named.ending;
  return name;
}

/// Collects the models that `node` of a IIIF manifest paints: everything with a body, and its
/// sources. `vessel`: the number of the Choice that contains it; below 0: each is a vessel of its
/// own. `known`: the names already in `out`.
void painted(const json& node, int depth, std::vector<Named>& out, std::set<std::string>& known,
             int vessel = -1) {
  if (depth > 24) return;
  if (node.is_array()) {
    for (const json& entry : node) painted(entry, depth + 1, out, known, vessel);
    return;
  }
  if (!node.is_object()) return;
  const std::string type = json_words::string_in(node, "type"),
                    ending = ending_of_type(json_words::string_in(node, "format"));
  const int next = static_cast<int>(out.size());
  if (type == "Choice" && vessel < 0) vessel = next;
  std::string id = json_words::string_in(node, "id");
  if (id.empty()) id = json_words::string_in(node, "@id");
  if (!id.empty() && (type == "Model" || !ending.empty() ||
                      (type != "Manifest" && is_mesh_ending(ending_of(id))))) {
    if (known.insert(id).second) out.push_back({id, ending, 0, vessel < 0 ? next : vessel});
    return;
  }
  for (const char* key : {"items", "body", "source", "content"})
    if (const json* inside = json_words::member(node, key))
      painted(*inside, depth + 1, out, known, vessel);
}

/// Collects what a manifest, and each canvas, offers besides the pictures.
void offered(const json& node, int depth, std::vector<Named>& out, std::set<std::string>& known) {
  if (const json* rendering = json_words::member(node, "rendering"))
    painted(*rendering, 0, out, known);
  for (const json* inside : each(node, "items"))
    if (depth < 2) offered(*inside, depth + 1, out, known);
}

std::vector<Named> models_of_manifest(const json& doc) {
  std::vector<Named> out;
  std::set<std::string> known;
  painted(doc, 0, out, known);
  if (out.empty()) offered(doc, 0, out, known);
  return out;
}

int rank_of(const json& derivative) {
  constexpr const char* kQualities[] = {"Thumb", "Low", "Medium", "High", "Highest"};
  const std::string quality = json_words::string_in(derivative, "quality");
  const auto* at = std::find(std::begin(kQualities), std::end(kQualities), quality);
  return at == std::end(kQualities) ? 0 : 1 + static_cast<int>(at - std::begin(kQualities));
}

std::vector<Named> models_of_voyager(const json& model) {
  std::vector<Named> out;
  for (const json* derivative : each(model, "derivatives"))
    for (const json* asset : each(*derivative, "assets")) {
      const std::string type = json_words::string_in(*asset, "type"),
                        uri = json_words::string_in(*asset, "uri");
      if ((type == "Model" || type == "Geometry") && is_mesh_ending(ending_of(uri)))
        out.push_back({uri, "", rank_of(*derivative)});
    }
  std::stable_sort(out.begin(), out.end(),
                   [](const Named& a, const Named& b) { return a.rank > b.rank; });
  return out;
}

/// The path of `named`, or why it cannot be used.
Result<fs::path> found(const fs::path& document, const Named& named) {
  const std::string shown = json_words::tidy(named.name.substr(0, 120));
  if (is_on_the_web(named.name)) {
    const std::string own = file_of_address(named);
    auto beside = find_vessel_file_beneath(document.parent_path(), own, document.string());
    if (beside) return beside;
    return problem(document.string(),
                   "its model is " + shown + ", but the kiosk opens nothing from a network.",
                   "Download it first, and put it beside this file as " +
                       json_words::tidy(own.substr(0, 80)) + ".");
  }
  return find_vessel_file_beneath(document.parent_path(), named.name, document.string());
}

// ---- its texts

/// The value of IIIF metadata whose label is one of `labels`, in lower case.
std::string metadata(const json& doc, std::initializer_list<const char*> labels) {
  for (const char* wanted : labels)
    for (const json* pair : each(doc, "metadata")) {
      const json *label = json_words::member(*pair, "label"),
                 *value = json_words::member(*pair, "value");
      if (label != nullptr && value != nullptr &&
          json_words::lower(json_words::words_of(*label)) == wanted)
        return json_words::words_of(*value);
    }
  return "";
}

/// Removes the little HTML that IIIF texts may hold. A "<" that begins no tag stays.
std::string without_tags(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char next = at + 1 < text.size() ? text[at + 1] : ' ';
    const bool tag =
        (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z') || next == '/' || next == '!';
    const std::size_t end = text[at] == '<' && tag ? text.find('>', at) : std::string::npos;
    if (end == std::string::npos)
      out += text[at];
    else
      at = end;
  }
  return json_words::tidy(out);
}

std::map<std::string, std::string> titles_of(const json& value) {
  std::map<std::string, std::string> titles = json_words::by_language(value);
  for (auto& [language, title] : titles) title = without_tags(title);
  return titles;
}

GltfCredit credit_of_manifest(const json& doc) {
  GltfCredit out;
  if (const json* label = json_words::member(doc, "label")) {
    out.title = without_tags(json_words::words_of(*label));
    out.titles = titles_of(*label);
  }
  out.description = without_tags(json_words::first_of(doc, {"summary", "description"}));
  for (const char* key : {"requiredStatement", "attribution"})
    if (const json* statement = json_words::member(doc, key); statement && out.copyright.empty()) {
      const json* value = json_words::member(*statement, "value");
      out.copyright = without_tags(json_words::words_of(value != nullptr ? *value : *statement));
    }
  out.licence = json_words::first_of(doc, {"rights", "license"});
  if (const std::string named = licence_named_in(out.licence); !named.empty()) out.licence = named;
  out.institution = [&] {
    for (const json* provider : each(doc, "provider"))
      if (const json* label = json_words::member(*provider, "label"))
        return without_tags(json_words::words_of(*label));
    return without_tags(
        metadata(doc, {"institution", "museum", "repository", "holding institution"}));
  }();
  out.accession = without_tags(metadata(
      doc, {"accession number", "accession", "object number", "inventory number", "identifier"}));
  out.culture = without_tags(metadata(doc, {"culture", "origin", "place of origin", "place"}));
  out.date = without_tags(metadata(doc, {"date", "date created", "period"}));
  for (const json* page : each(doc, "homepage"))
    if (out.address.empty()) out.address = json_words::page_of(*page, {"id", "@id"});
  return out;
}

GltfCredit credit_of_voyager(const json& doc, const std::vector<const json*>& metas) {
  GltfCredit out;
  const auto fill = [](std::string& place, std::string words) {
    if (place.empty()) place = without_tags(words);
  };
  for (const json* meta : metas) {
    const json* collection = json_words::member(*meta, "collection");
    if (collection == nullptr) continue;
    const json& c = *collection;
    if (const json* titles = json_words::member(c, "titles"); titles && out.titles.empty())
      out.titles = titles_of(*titles);
    fill(out.title, json_words::first_of(c, {"title", "titles", "objectname", "name"}));
    fill(out.description, json_words::first_of(c, {"intro", "intros", "summary", "description"}));
    fill(out.institution, json_words::first_of(c, {"museum", "unit", "datasource", "institution"}));
    fill(out.accession, json_words::first_of(c, {"accessionnumber", "accession", "catalognumber",
                                                 "objectnumber", "edanrecordid"}));
    fill(out.culture, json_words::first_of(c, {"culture", "place"}));
    fill(out.date, json_words::first_of(c, {"date", "period"}));
    fill(out.copyright, json_words::first_of(c, {"creditline", "credit"}));
    fill(out.licence, json_words::first_of(c, {"license", "licence", "rights", "usage"}));
    if (out.address.empty())
      out.address =
          json_words::page_of(c, {"url", "recordlink", "record_link", "guid", "link", "homepage"});
  }
  if (const json* asset = json_words::member(doc, "asset"))
    if (const std::string words = without_tags(json_words::first_of(*asset, {"copyright"}));
        words != out.copyright && !words.empty())
      out.copyright += (out.copyright.empty() ? "" : ". ") + words;
  if (const std::string named = licence_named_in(out.licence); !named.empty()) out.licence = named;
  return out;
}

double metres_in(const std::string& unit) {
  if (unit == "mm") return 0.001;
  if (unit == "cm") return 0.01;
  if (unit == "m") return 1.0;
  if (unit == "in") return 0.0254;
  if (unit == "ft") return 0.3048;
  return 0.0;
}

Problem no_document(const std::string& name, const std::string& what) {
  return {name, what, "Name a IIIF manifest, a Smithsonian document.json, or the GLB itself."};
}

Problem no_model(const std::string& name) {
  return {name, "it names no 3D model that can be read.",
          "Name the vessel's GLB itself; pictures alone make no shape."};
}

Problem several_models(const fs::path& file, std::size_t count) {
  return {file.string(), "it shows " + std::to_string(count) + " models, but a vessel is one.",
          "Name the vessel's GLB itself."};
}

/// The first of `models` that exists, else the Problem of the best one.
Result<fs::path> first_found(const fs::path& file, const std::vector<Named>& models) {
  if (models.empty()) return tl::unexpected(no_model(file.string()));
  Result<fs::path> first = found(file, models.front());
  for (std::size_t i = 1; !first && i < models.size(); ++i)
    if (auto next = found(file, models[i])) return next;
  return first;
}

Result<ScanDocument> read_manifest(const fs::path& file, const json& doc) {
  const std::vector<Named> models = models_of_manifest(doc);
  std::set<int> vessels;
  for (const Named& model : models) vessels.insert(model.vessel);
  if (vessels.size() > 1) return tl::unexpected(several_models(file, vessels.size()));
  auto model = first_found(file, models);
  if (!model) return tl::unexpected<Problem>(model.error());
  return ScanDocument{*model, 0.0, credit_of_manifest(doc)};
}

Result<ScanDocument> read_voyager(const fs::path& file, const json& doc) {
  std::vector<std::pair<const json*, std::vector<Named>>> models;
  for (const json* model : each(doc, "models"))
    if (auto named = models_of_voyager(*model); !named.empty())
      models.emplace_back(model, std::move(named));
  if (models.empty()) return tl::unexpected(no_model(file.string()));
  if (models.size() > 1) return tl::unexpected(several_models(file, models.size()));
  auto model = first_found(file, models.front().second);
  if (!model) return tl::unexpected<Problem>(model.error());
  return ScanDocument{*model, metres_in(json_words::string_in(*models.front().first, "units")),
                      credit_of_voyager(doc, each(doc, "metas"))};
}

}  // namespace

bool is_document_ending(const fs::path& file) {
  return json_words::lower(file.extension().string()) == ".json";
}

bool is_scan_document(const fs::path& file) {
  if (!is_document_ending(file)) return false;
  const settings::ReaderLimits limits;
  const auto bytes =
      read_vessel_file(file, static_cast<std::size_t>(limits.json_mb) << 20, "json_mb");
  if (!bytes) return false;
  const auto container = split_gltf(file.string(), *bytes, limits);
  if (!container) return false;
  const json doc = json::parse(container->json, nullptr, false);
  return doc.is_object() && (is_voyager(doc) || is_manifest(doc));
}

Result<ScanDocument> read_scan_document(const fs::path& file,
                                        const settings::ReaderLimits& limits) {
  const std::string name = file.string();
  const auto bytes =
      read_vessel_file(file, static_cast<std::size_t>(limits.json_mb) << 20, "json_mb");
  if (!bytes) return tl::unexpected<Problem>(bytes.error());
  const auto container = split_gltf(name, *bytes, limits);
  if (!container) return tl::unexpected(no_document(name, container.error().what));
  const json doc = json::parse(container->json, nullptr, false);
  if (doc.is_discarded()) return tl::unexpected(no_document(name, "its JSON cannot be parsed."));
  if (is_voyager(doc)) return read_voyager(file, doc);
  if (is_manifest(doc)) return read_manifest(file, doc);
  return tl::unexpected(
      no_document(name, "it is neither a IIIF manifest nor a Smithsonian document."));
}

}  // namespace onggi::content
