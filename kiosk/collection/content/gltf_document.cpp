#include "kiosk/collection/content/gltf_document.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "kiosk/collection/content/data_uri.h"
#include "kiosk/collection/content/gltf_container.h"
#include "kiosk/collection/content/gltf_credit_reader.h"
#include "kiosk/collection/content/gltf_materials.h"
#include "kiosk/collection/content/gltf_strictness.h"
#include "kiosk/collection/content/json_words.h"
#include "kiosk/collection/content/vessel_file.h"

namespace onggi::content {

namespace {

using json_words::index_in;
using json_words::list_of;
using json_words::member;
using json_words::string_in;
using json_words::within;
using nlohmann::json;

constexpr const char* kDraco = "KHR_draco_mesh_compression";

/// True for extensions that Onggi reads, or can ignore without changing the shape.
bool can_do_without_or_knows(const std::string& extension) {
  static const std::array<const char*, 3> kKnown{"KHR_mesh_quantization", "EXT_meshopt_compression",
#ifdef ONGGI_HAS_DRACO
                                                 kDraco
#else
                                                 "KHR_mesh_quantization"
#endif
  };
  if (std::find(kKnown.begin(), kKnown.end(), extension) != kKnown.end()) return true;
  for (const char* look : {"KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_",
                           "EXT_lights_", "MSFT_texture_", "KHR_xmp"})
    if (extension.starts_with(look)) return true;
  return false;
}

Result<void> check_extensions(const std::string& name, const json& doc) {
  for (const json& entry : list_of(doc, "extensionsRequired")) {
    if (!entry.is_string() || can_do_without_or_knows(entry.get<std::string>())) continue;
    return problem(name,
                   "it requires the extension " + entry.get<std::string>().substr(0, 80) +
                       ", which Onggi does not read.",
                   "Export the vessel again without that extension (compression off).");
  }
  return {};
}

std::size_t whole(const json& object, const char* key, std::size_t otherwise) {
  const json& value = within(object, key);
  return value.is_number_unsigned() ? value.get<std::size_t>() : otherwise;
}

/// Three finite numbers.
std::optional<std::array<double, 3>> triple(const json& list) {
  std::array<double, 3> out{};
  if (!list.is_array() || list.size() != 3) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!list[k].is_number()) return std::nullopt;
    out[k] = list[k].get<double>();
  }
  return out;
}

/// Notes the bounds that accessors of three numbers declare.
void note_bounds(const json& doc, GltfDocument& out) {
  const json& accessors = list_of(doc, "accessors");
  std::size_t odd = 0, first_odd = 0;
  for (std::size_t i = 0; i < accessors.size(); ++i) {
    const json *low = member(accessors[i], "min"), *high = member(accessors[i], "max");
    if (low == nullptr || high == nullptr || string_in(accessors[i], "type") != "VEC3") continue;
    const auto a = triple(*low), b = triple(*high);
    if (a && b)
      out.bounds[static_cast<int>(i)] = {*a, *b};
    else if (odd++ == 0)
      first_odd = i;
  }
  // One line a file: a scan in pieces has hundreds of accessors from the same exporter.
  if (odd > 0)
    out.warnings.push_back("The bounds declared for accessor " + std::to_string(first_odd) +
                           (odd > 1 ? " and " + std::to_string(odd - 1) + " more" : "") +
                           " are not three numbers each; the data is used as it is.");
}

constexpr auto kAbsent = static_cast<std::size_t>(-1);

DracoPrimitive draco_of(const json& ext, const json& declared, const json& accessors) {
  constexpr int kMostSets = 8;
  const json& ids = within(ext, "attributes");
  DracoPrimitive out{index_in(ext, "bufferView"),
                     index_in(ids, "POSITION"),
                     index_in(ids, "NORMAL"),
                     index_in(ids, "COLOR_0"),
                     {},
                     {},
                     index_in(declared, "POSITION")};
  for (int n = 0; n < kMostSets; ++n) {
    const std::string key = "TEXCOORD_" + std::to_string(n);
    if (const int id = index_in(ids, key); id >= 0) out.places[n] = id;
    const int at = index_in(declared, key);
    if (at >= 0 && static_cast<std::size_t>(at) < accessors.size() &&
        within(accessors[static_cast<std::size_t>(at)], "normalized") == true)
      out.normalized.insert(n);
  }
  return out;
}

/// Reads the extensions that tinygltf ignores.
void note_compression(const json& doc, GltfDocument& out) {
  const json &views = list_of(doc, "bufferViews"), &meshes = list_of(doc, "meshes");
  for (std::size_t i = 0; i < views.size(); ++i)
    if (const json* ext = member(within(views[i], "extensions"), "EXT_meshopt_compression"))
      out.meshopt[static_cast<int>(i)] = {
          whole(*ext, "buffer", kAbsent),     whole(*ext, "byteOffset", 0),
          whole(*ext, "byteLength", kAbsent), whole(*ext, "byteStride", kAbsent),
          whole(*ext, "count", kAbsent),      string_in(*ext, "mode"),
          string_in(*ext, "filter")};
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const json& primitives = list_of(meshes[m], "primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p)
      if (const json* ext = member(within(primitives[p], "extensions"), kDraco))
        out.draco[{static_cast<int>(m), static_cast<int>(p)}] =
            draco_of(*ext, within(primitives[p], "attributes"), list_of(doc, "accessors"));
  }
}

/// Calls `change` with each object of the list `key`.
template <class Change>
void each_object(json& doc, const char* key, const Change& change) {
  const auto list = doc.find(key);
  if (list == doc.end() || !list->is_array()) return;
  for (json& object : *list)
    if (object.is_object()) change(object);
}

/// Keeps only the named members of each object in the list `key`.
void keep(json& doc, const char* key, std::initializer_list<const char*> wanted) {
  each_object(doc, key, [&](json& object) {
    json kept = json::object();
    for (const char* name : wanted)
      if (const json* value = member(object, name)) kept[name] = *value;
    object = std::move(kept);
  });
}

/// Cuts the document down to the used parts. Every buffer becomes one byte inside the file, because
/// the accessor reader uses our own copies and tinygltf need not hold a second one. No file name is
/// left, so tinygltf, which opens files differently from version to version, opens none.
json cut_down(const json& doc, std::size_t buffers) {
  json out{{"asset", {{"version", "2.0"}}}, {"buffers", json::array()}};
  for (const char* key : {"scene", "scenes", "nodes", "meshes", "accessors", "bufferViews"})
    if (const json* value = member(doc, key)) out[key] = *value;
  keep(out, "scenes", {"nodes"});
  keep(out, "nodes", {"name", "mesh", "children", "matrix", "translation", "rotation", "scale"});
  keep(out, "meshes", {"name", "primitives"});
  keep(out, "bufferViews", {"buffer", "byteOffset", "byteLength", "byteStride", "target"});
  keep(out, "accessors",
       {"bufferView", "byteOffset", "componentType", "normalized", "count", "type", "sparse"});
  // tinygltf requires bytes for the accessors of a Draco primitive, which have none.
  each_object(out, "meshes", [](json& mesh) {
    each_object(mesh, "primitives", [](json& primitive) {
      if (member(within(primitive, "extensions"), kDraco) == nullptr) return;
      primitive["attributes"] = json::object();
      primitive.erase("indices");
    });
    keep(mesh, "primitives", {"attributes", "indices", "material", "mode"});
  });
  for (std::size_t i = 0; i < buffers; ++i)
    out["buffers"].push_back(
        {{"byteLength", 1}, {"uri", "data:application/octet-stream;base64,AA=="}});
  return out;
}

Result<void> load_buffers(const std::filesystem::path& folder, const json& doc,
                          GltfContainer& container, std::size_t most, GltfDocument& out) {
  const json& list = list_of(doc, "buffers");
  std::size_t left = most;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const json& buffer = list[i];
    const std::string uri = string_in(buffer, "uri");
    const std::string here = out.name + ", buffer " + std::to_string(i);
    const std::size_t wanted = whole(buffer, "byteLength", 0);
    const auto too_few = [&](std::size_t there) {
      return broken_gltf(here, "it should have " + std::to_string(wanted) + " bytes, but it has " +
                                   std::to_string(there) + ".");
    };
    const auto too_large = [&](std::size_t size) {
      return tl::unexpected(beyond_limit(
          here, "the buffers have " + std::to_string((most - left + size) >> 20) + " MiB together",
          std::to_string(most >> 20) + " MiB", "file_mb"));
    };
    std::span<const unsigned char> bytes;
    if (const auto data = data_behind(uri, container)) {
      const auto text = std::exchange(container.data[*data], {}).in(out.file);
      if (wanted > left) return too_large(wanted);
      if (most_bytes_in(text) < wanted) return too_few(most_bytes_in(text));
      const auto decoded = decode_data_uri(text, wanted);
      if (!decoded) return broken_gltf(here, "its data within the file cannot be decoded.");
      bytes = *decoded;
    } else if (uri.starts_with("data:")) {
      return broken_gltf(here, "its data within the file cannot be decoded.");
    } else if (!uri.empty()) {
      auto read = read_vessel_file_beneath(folder, uri, left, here);
      if (!read) return tl::unexpected<Problem>(read.error());
      bytes = out.beside.emplace_back(std::move(*read));
    } else if (i == 0 && container.bin) {
      bytes = container.bin->in(out.file);
    }
    // A buffer without uri or chunk is the fallback of compressed views, which is never read.
    if (bytes.size() < wanted && !(uri.empty() && !(i == 0 && container.bin)))
      return too_few(bytes.size());
    bytes = bytes.first(std::min(bytes.size(), wanted));
    if (bytes.size() > left) return too_large(bytes.size());
    left -= bytes.size();
    out.buffers.push_back(bytes);
  }
  return {};
}

std::string first_line(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  return line.size() > 160 ? line.substr(0, 160) + "..." : line;
}

}  // namespace

tl::unexpected<Problem> unsound(const std::string& where, std::string what) {
  return problem(where, std::move(what),
                 "Export the vessel again; a glTF validator shows the place.");
}

Result<GltfDocument> open_gltf(const std::filesystem::path& file,
                               const settings::ReaderLimits& limits) {
  GltfDocument out;
  out.name = file.string();
  const auto most = static_cast<std::size_t>(limits.file_mb) << 20;
  auto bytes = read_vessel_file(file, most);
  if (!bytes) return tl::unexpected<Problem>(bytes.error());
  out.file = std::move(*bytes);
  auto container = split_gltf(out.name, out.file, limits);
  if (!container) return tl::unexpected<Problem>(container.error());

  const json doc = json::parse(container->json, nullptr, false);
  if (doc.is_discarded() || !doc.is_object())
    return broken_gltf(out.name, "it is not a glTF file: its JSON cannot be parsed.");
  if (!string_in(within(doc, "asset"), "version").starts_with("2."))
    return broken_gltf(out.name, "it does not say that it is glTF of version 2.");
  if (auto good = check_extensions(out.name, doc); !good)
    return tl::unexpected<Problem>(good.error());
  if (auto good = check_strictly(out.name, doc, out.warnings); !good)
    return tl::unexpected<Problem>(good.error());
  note_compression(doc, out);
  note_bounds(doc, out);
  out.credit = read_credit(doc);
  if (auto good = load_buffers(file.parent_path(), doc, *container, most, out); !good)
    return tl::unexpected<Problem>(good.error());
  read_materials(doc, file.parent_path(), *container, limits, out);

  std::string error, warning;
  out.model = std::make_shared<tinygltf::Model>();
  try {
    const std::string text =
        cut_down(doc, out.buffers.size()).dump(-1, ' ', false, json::error_handler_t::replace);
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader([](tinygltf::Image*, const int, std::string*, std::string*, int, int,
                             const unsigned char*, int, void*) { return true; },
                          nullptr);
    if (!loader.LoadASCIIFromString(out.model.get(), &error, &warning, text.c_str(),
                                    static_cast<unsigned int>(text.size()), ""))
      return broken_gltf(out.name, "it is not valid glTF: " + first_line(error));
  } catch (const std::exception& e) {
    return broken_gltf(out.name, std::string("it is not valid glTF: ") + first_line(e.what()));
  }
  return out;
}

}  // namespace onggi::content
