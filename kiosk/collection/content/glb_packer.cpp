#include "kiosk/collection/content/glb_packer.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>

#include "kiosk/collection/content/data_uri.h"
#include "kiosk/collection/content/glb.h"
#include "kiosk/collection/content/gltf_container.h"
#include "kiosk/collection/content/vessel_file.h"
#include "kiosk/ground/files/byte_writer.h"

namespace onggi::content {
namespace {

using nlohmann::json;

/// The media type of a PNG, JPEG, WebP or KTX2, from its first bytes.
std::string mime_of(std::span<const std::byte> bytes) {
  switch (bytes.empty() ? 0 : std::to_integer<int>(bytes[0])) {
    case 0x89:
      return "image/png";
    case 0xAB:
      return "image/ktx2";
    case 'R':
      return "image/webp";
    default:
      return "image/jpeg";
  }
}

class Packer {
 public:
  Packer(const std::filesystem::path& file, files::Bytes& bytes, GltfContainer& container,
         std::size_t most)
      : file_(file), bytes_(bytes), container_(container), left_(most) {}

  Result<void> buffers(json& document) {
    if (!document.contains("buffers") || !document["buffers"].is_array()) return {};
    json kept = json::array({json::object()});
    for (const json& buffer : document["buffers"]) {
      const std::string uri = uri_of(buffer);
      if (uri.empty()) {  // the fallback of compressed views has no bytes
        moved_.push_back({kept.size(), 0});
        kept.push_back(buffer);
        continue;
      }
      auto read = read_in(uri);
      if (!read) return tl::unexpected<Problem>(read.error());
      moved_.push_back({0, *read});
    }
    document["buffers"] = std::move(kept);
    if (document.contains("bufferViews") && document["bufferViews"].is_array())
      for (json& view : document["bufferViews"]) {
        move(view);
        if (view.is_object() && view.contains("extensions") && view["extensions"].is_object() &&
            view["extensions"].contains("EXT_meshopt_compression"))
          move(view["extensions"]["EXT_meshopt_compression"]);
      }
    return {};
  }

  void images(json& document) {
    if (!document.contains("images") || !document["images"].is_array()) return;
    for (json& image : document["images"]) {
      const std::string uri = uri_of(image);
      if (uri.empty()) continue;
      const auto at = read_in(uri);
      if (!at) continue;
      const auto run = bin_.bytes().subspan(*at);
      image.erase("uri");
      if (!image.contains("mimeType")) image["mimeType"] = mime_of(run);
      if (!image.contains("name") && uri.rfind("data:", 0) != 0) image["name"] = uri;
      if (!document.contains("bufferViews") || !document["bufferViews"].is_array())
        document["bufferViews"] = json::array();
      image["bufferView"] = document["bufferViews"].size();
      document["bufferViews"].push_back(
          {{"buffer", 0}, {"byteOffset", *at}, {"byteLength", run.size()}});
    }
  }

  std::vector<std::byte> finish(json& document) {
    if (!document.contains("buffers")) document["buffers"] = json::array({json::object()});
    document["buffers"][0] = {{"byteLength", bin_.size()}};
    files::ByteWriter text;
    text.text(document.dump(-1, ' ', false, json::error_handler_t::replace));
    text.pad(4, ' ');
    bin_.pad(4, '\0');
    files::ByteWriter out(28 + text.size() + bin_.size());
    out.u32(kGlbMagic);
    out.u32(2);
    out.u32(static_cast<std::uint32_t>(28 + text.size() + bin_.size()));
    out.u32(static_cast<std::uint32_t>(text.size()));
    out.u32(kGlbJson);
    out.append(text.bytes());
    out.u32(static_cast<std::uint32_t>(bin_.size()));
    out.u32(kGlbBin);
    out.append(bin_.bytes());
    return out.take();
  }

 private:
  static std::string uri_of(const json& object) {
    if (!object.is_object() || !object.contains("uri") || !object["uri"].is_string()) return "";
    return object["uri"].get<std::string>();
  }

  /// Start of the data behind `uri` in the BIN chunk; it goes to the chunk's end.
  Result<std::size_t> read_in(const std::string& uri) {
    // Align compressed floats to their size.
    bin_.pad(8, '\0');
    const std::size_t at = bin_.size();
    if (const auto data = data_behind(uri, container_)) {
      const auto text = std::exchange(container_.data[*data], {}).in(bytes_);
      const auto decoded = decode_data_uri(text, std::min(left_, most_bytes_in(text)));
      if (!decoded) return broken_gltf(file_.string(), "its data within the file is damaged.");
      bin_.append(std::as_bytes(*decoded));
    } else {
      const auto read = read_vessel_file_beneath(file_.parent_path(), uri, left_, file_.string());
      if (!read) return tl::unexpected<Problem>(read.error());
      bin_.append(std::as_bytes(std::span(*read)));
    }
    left_ -= std::min(left_, bin_.size() - at);
    return at;
  }

  void move(json& view) const {
    if (!view.is_object() || !view.contains("buffer") || !view["buffer"].is_number_unsigned())
      return;
    const auto buffer = view["buffer"].get<std::size_t>();
    if (buffer >= moved_.size()) return;
    const json offset = view.value("byteOffset", json(0u));
    view["buffer"] = moved_[buffer].first;
    if (offset.is_number_unsigned())
      view["byteOffset"] = offset.get<std::size_t>() + moved_[buffer].second;
  }

  const std::filesystem::path& file_;
  files::Bytes& bytes_;
  GltfContainer& container_;
  std::size_t left_;
  files::ByteWriter bin_;
  std::vector<std::pair<std::size_t, std::size_t>>
      moved_;  ///< The new buffer of each buffer, and the offset in it.
};

}  // namespace

Result<std::vector<std::byte>> pack_glb(const std::filesystem::path& file,
                                        const settings::ReaderLimits& limits) {
  const std::string name = file.string();
  const auto most = static_cast<std::size_t>(limits.file_mb) << 20;
  auto bytes = read_vessel_file(file, most);
  if (!bytes) return tl::unexpected<Problem>(bytes.error());
  auto container = split_gltf(name, *bytes, limits);
  if (!container) return tl::unexpected<Problem>(container.error());
  json document = json::parse(container->json, nullptr, false);
  if (!document.is_object()) return broken_gltf(name, "it is not a glTF file.");
  Packer packer(file, *bytes, *container, most);
  if (auto good = packer.buffers(document); !good) return tl::unexpected<Problem>(good.error());
  packer.images(document);
  return packer.finish(document);
}

}  // namespace onggi::content
