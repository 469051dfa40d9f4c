#include "kiosk/collection/content/gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "kiosk/collection/content/data_uri.h"
#include "kiosk/collection/content/json_words.h"
#include "kiosk/collection/content/vessel_file.h"

namespace onggi::content {
namespace {

using json_words::index_in;
using json_words::list_of;
using json_words::string_in;
using json_words::within;
using nlohmann::json;

/// Element `index` of the list `key`; null JSON if there is none.
const json& element(const json& object, const char* key, int index) {
  static const json kNothing;
  const json& list = list_of(object, key);
  const auto at = static_cast<std::size_t>(index);
  return index < 0 || at >= list.size() ? kNothing : list[at];
}

double number_in(const json& list, std::size_t index, double otherwise) {
  return list.is_array() && index < list.size() && list[index].is_number()
             ? list[index].get<double>()
             : otherwise;
}

/// The index in "images" of the picture to decode for a texture; -1: none.
int image_of(const json& texture) {
  const json& all = within(texture, "extensions");
  const int webp = index_in(within(all, "EXT_texture_webp"), "source");
  if (webp >= 0) return webp;
  const int own = index_in(texture, "source");
  return own >= 0 ? own : index_in(within(all, "KHR_texture_basisu"), "source");
}

Coloring::Wrap wrap_of(const json& sampler, const char* key) {
  constexpr int kClamp = 33071, kMirror = 33648;  // glTF 2.0, section 5.26
  const int value = index_in(sampler, key);
  return value == kClamp    ? Coloring::Wrap::clamp
         : value == kMirror ? Coloring::Wrap::mirror
                            : Coloring::Wrap::repeat;
}

/// KHR_texture_transform: translation * rotation * scale.
void place_texture(const json& use, GltfMaterial& material) {
  const json& transform = within(within(use, "extensions"), "KHR_texture_transform");
  material.coordinates = index_in(transform, "texCoord", index_in(use, "texCoord", 0));
  if (!transform.is_object()) return;
  const json &offset = within(transform, "offset"), &scale = within(transform, "scale");
  const json& turn = within(transform, "rotation");
  const double angle = turn.is_number() ? turn.get<double>() : 0.0;
  const double c = std::cos(angle), s = std::sin(angle);
  const double across = number_in(scale, 0, 1.0), down = number_in(scale, 1, 1.0);
  material.placed = {c * across,  s * down, number_in(offset, 0, 0.0),
                     -s * across, c * down, number_in(offset, 1, 0.0)};
}

class Pictures {
 public:
  Pictures(const json& document, const std::filesystem::path& folder, GltfContainer& container,
           std::size_t most, GltfDocument& out)
      : document_(document),
        folder_(folder),
        container_(container),
        most_(most),
        left_(most),
        out_(out) {}

  /// The index of the picture in out.pictures; reads it at the first call.
  int of_image(int image) {
    const auto [found, fresh] = known_.try_emplace(image, static_cast<int>(out_.pictures.size()));
    if (fresh) out_.pictures.push_back(read(image));
    return found->second;
  }

 private:
  GltfPicture read(int index) {
    GltfPicture picture;
    const json& image = element(document_, "images", index);
    const std::string uri = string_in(image, "uri");
    const json& name = within(image, "name");
    picture.name = name.is_string()                          ? name.get<std::string>()
                   : uri.empty() || uri.starts_with("data:") ? std::to_string(index)
                                                             : uri;
    picture.name = picture.name.substr(0, 80);
    picture.view = index_in(image, "bufferView");
    if (picture.view >= 0) return picture;
    if (read_ >= kMostPictures) {
      picture.fault = "the limit of pictures is " + std::to_string(kMostPictures);
      return picture;
    }
    if (const auto data = data_behind(uri, container_)) {
      const auto text = std::exchange(container_.data[*data], {}).in(out_.file);
      // Ask for one byte more than is left, to tell a picture that is too large from one that just
      // fits.
      const auto decoded = decode_data_uri(text, std::min(left_ + 1, most_bytes_in(text)));
      if (!decoded || decoded->empty())
        picture.fault = "its data within the file cannot be decoded";
      else if (decoded->size() > left_)
        picture.fault = "the limit for them together is " + std::to_string(most_ >> 20) +
                        " MiB: scale its pictures down, or raise file_mb in the exhibit's [reader]";
      else
        picture.bytes = *decoded;
    } else if (uri.empty() || uri.starts_with("data:")) {
      picture.fault = "there is no such picture in the file";
    } else {
      auto bytes = read_vessel_file_beneath(folder_, uri, left_, out_.name);
      if (bytes)
        picture.bytes = out_.beside.emplace_back(std::move(*bytes));
      else
        picture.fault = bytes.error().what;
    }
    left_ -= picture.bytes.size();
    if (!picture.bytes.empty()) ++read_;
    return picture;
  }

  const json& document_;
  const std::filesystem::path& folder_;
  GltfContainer& container_;
  const std::size_t most_;
  std::size_t left_, read_ = 0;
  GltfDocument& out_;
  std::map<int, int> known_;
};

}  // namespace

void read_materials(const json& document, const std::filesystem::path& folder,
                    GltfContainer& container, const settings::ReaderLimits& limits,
                    GltfDocument& out) {
  const auto most = static_cast<std::size_t>(limits.file_mb) << 20;
  Pictures pictures(document, folder, container, most, out);
  for (const json& given : list_of(document, "materials")) {
    GltfMaterial material;
    const json& pbr = within(given, "pbrMetallicRoughness");
    const json& gloss = within(within(given, "extensions"), "KHR_materials_pbrSpecularGlossiness");
    const json& factor =
        gloss.is_object() ? within(gloss, "diffuseFactor") : within(pbr, "baseColorFactor");
    for (std::size_t k = 0; k < 3; ++k)
      material.factor[k] = static_cast<float>(std::clamp(number_in(factor, k, 1.0), 0.0, 1.0));
    const json& use =
        gloss.is_object() ? within(gloss, "diffuseTexture") : within(pbr, "baseColorTexture");
    material.textured = use.is_object();
    if (material.textured) {
      const json& texture = element(document, "textures", index_in(use, "index"));
      const json& sampler = element(document, "samplers", index_in(texture, "sampler"));
      material.across = wrap_of(sampler, "wrapS");
      material.down = wrap_of(sampler, "wrapT");
      place_texture(use, material);
      if (limits.texture_px > 0) material.picture = pictures.of_image(image_of(texture));
    }
    out.materials.push_back(material);
  }
}

}  // namespace onggi::content
