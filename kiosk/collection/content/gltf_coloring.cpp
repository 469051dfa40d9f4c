#include "kiosk/collection/content/gltf_coloring.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

#include "kiosk/collection/content/texture_file.h"

namespace onggi::content {
namespace {

constexpr std::size_t kMostCoats = 255;  // a byte of Coloring::picture can hold no more

/// The accessor of an attribute; -1: none.
int accessor_of(const tinygltf::Primitive& primitive, const std::string& attribute) {
  const auto found = primitive.attributes.find(attribute);
  return found == primitive.attributes.end() ? -1 : found->second;
}

template <class List>
void lay(List& into, std::size_t first, const List& from) {
  into.resize(first + from.size());
  std::copy(from.begin(), from.end(), into.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace

void GltfColors::note(const std::string& what, const std::string& why, Left left) {
  if (left == Left::clay) ++clay_;
  if (faults_++ == 0) first_fault_ = what + ": " + why;
}

void GltfColors::add(const tinygltf::Primitive& primitive, const DecodedPrimitive* draco,
                     std::size_t count, GltfReader& reader) {
  Run run{count_, count, primitive.material, false};
  count_ += count;
  const auto materials = static_cast<int>(document_.materials.size());
  if (run.material < 0 || run.material >= materials) run.material = -1;

  std::vector<std::array<float, 3>> colors;
  if (draco != nullptr) {
    colors = draco->colors;
    if (draco->colors_fault) note("COLOR_0", "its Draco compression is damaged.", Left::without);
  } else if (const int accessor = accessor_of(primitive, "COLOR_0"); accessor >= 0) {
    if (auto read = reader.colors(accessor, document_.name))
      colors = std::move(*read);
    else
      note(read.error().where, read.error().what, Left::without);
    if (!colors.empty() && colors.size() != count)
      note("COLOR_0",
           "it has " + std::to_string(colors.size()) + " colours for " + std::to_string(count) +
               " corners.",
           Left::without);
  }
  if (colors.size() == count && count > 0) {
    run.colored = true;
    lay(vertex_colors_, run.first, colors);
  }
  if (run.material >= 0 && document_.materials[static_cast<std::size_t>(run.material)].textured) {
    const int set = document_.materials[static_cast<std::size_t>(run.material)].coordinates;
    std::vector<std::array<float, 2>> places;
    if (draco != nullptr) {
      places = draco->places;
    } else {
      auto read =
          reader.places(accessor_of(primitive, "TEXCOORD_" + std::to_string(set)), document_.name);
      if (read) places = std::move(*read);
    }
    if (places.size() == count)
      lay(places_, run.first, places);
    else
      note("TEXCOORD_" + std::to_string(set), "these picture coordinates cannot be read.");
    // Zero coordinates would show one pixel everywhere, and a tint without its picture is not its
    // colour.
    if (places.size() != count) run = {run.first, count, -1, false};
  }
  runs_.push_back(run);
}

/// Decodes all pictures. For each material: its place in `out.pictures` plus one, 0 if it wants
/// none, -1 if the picture cannot be read.
std::vector<int> GltfColors::decode(GltfReader& reader, Coloring& out) {
  std::vector<int> of_material(document_.materials.size(), 0);
  std::vector<bool> needed(document_.pictures.size(), false);
  for (const Run& run : runs_)
    if (run.material >= 0) {
      const GltfMaterial& m = document_.materials[static_cast<std::size_t>(run.material)];
      if (m.picture >= 0) needed[static_cast<std::size_t>(m.picture)] = true;
    }
  std::vector<std::span<const std::uint8_t>> wanted;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    const GltfPicture& picture = document_.pictures[i];
    const std::string what = "\"" + picture.name + "\"";
    if (!needed[i] || limits_.texture_px == 0) continue;
    if (!picture.fault.empty()) {
      note(what, picture.fault);
      continue;
    }
    auto bytes = picture.view < 0 ? Result<std::span<const unsigned char>>(picture.bytes)
                                  : reader.view(picture.view, document_.name);
    if (!bytes)
      note(what, bytes.error().what);
    else if (wanted.size() >= kMostPictures)
      note(what, "the limit of pictures is " + std::to_string(kMostPictures));
    else
      wanted.push_back(*bytes), which.push_back(i);
  }
  std::vector<std::shared_ptr<const textures::TexturePixels>> pixels(needed.size());
  const auto decoded = read_textures(wanted, limits_);
  if (!decoded) note("onggi-texture", decoded.error().what);
  for (std::size_t i = 0; decoded && i < decoded->size(); ++i)
    if ((*decoded)[i])
      pixels[which[i]] = std::make_shared<textures::TexturePixels>(*(*decoded)[i]);
    else
      note("\"" + document_.pictures[which[i]].name + "\"", (*decoded)[i].error());

  bool too_many = false;
  for (std::size_t m = 0; m < of_material.size(); ++m) {
    const GltfMaterial& material = document_.materials[m];
    if (!material.textured) continue;
    const auto& own =
        material.picture < 0 ? nullptr : pixels[static_cast<std::size_t>(material.picture)];
    if (own == nullptr) {
      of_material[m] = -1;
      continue;
    }
    const auto same =
        std::find_if(out.pictures.begin(), out.pictures.end(), [&](const Coloring::Picture& p) {
          return p.pixels == own && p.across == material.across && p.down == material.down;
        });
    of_material[m] = 1 + static_cast<int>(same - out.pictures.begin());
    if (same != out.pictures.end()) continue;
    if (out.pictures.size() == kMostCoats) {
      of_material[m] = -1;
      too_many = true;
    } else {
      out.pictures.push_back({own, material.across, material.down});
    }
  }
  if (too_many)
    note("its materials",
         "they apply pictures in more ways than the limit of " + std::to_string(kMostCoats) + "");
  return of_material;
}

Coloring GltfColors::finish(GltfReader& reader, std::vector<std::string>& warnings) {
  Coloring out;
  if (runs_.empty()) return out;
  const std::vector<int> of_material = decode(reader, out);
  if (faults_ > 0) {
    while (!first_fault_.empty() && first_fault_.back() == '.') first_fault_.pop_back();
    warnings.push_back(
        (faults_ == 1 ? "A colour of it cannot be read ("
                      : std::to_string(faults_) + " of its colours cannot be read (first ") +
        first_fault_ + "); " + (faults_ == 1 ? "that part is" : "those parts are") + " shown " +
        (clay_ == faults_ ? "as plain clay."
         : clay_ == 0     ? "without."
                          : "without, or as plain clay."));
  }
  out.colors.resize(count_);
  if (!out.pictures.empty()) {
    out.places.resize(count_);
    out.picture.resize(count_, 0);
  }
  for (const Run& run : runs_) {
    const bool has = run.material >= 0;
    const GltfMaterial material =
        has ? document_.materials[static_cast<std::size_t>(run.material)] : GltfMaterial{};
    const int picture = has ? of_material[static_cast<std::size_t>(run.material)] : 0;
    const bool clay = picture < 0 || (!has && !run.colored);
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        out.colors[i][k] =
            display_of(clay ? kClayColor[k]
                            : material.factor[k] * (run.colored ? vertex_colors_[i][k] : 1.0f));
      if (picture <= 0) continue;
      const auto& m = material.placed;
      const double u = places_[i][0], v = places_[i][1];
      const std::array<float, 2> at{static_cast<float>(m[0] * u + m[1] * v + m[2]),
                                    static_cast<float>(m[3] * u + m[4] * v + m[5])};
      if (std::isfinite(at[0]) && std::isfinite(at[1])) out.places[i] = at;
      out.picture[i] = static_cast<std::uint8_t>(picture);
    }
  }
  const bool one = out.pictures.empty() &&
                   std::all_of(out.colors.begin(), out.colors.end(),
                               [&](const auto& c) { return c == out.colors.front(); }) &&
                   std::none_of(runs_.begin(), runs_.end(), [](const Run& r) { return r.colored; });
  // GltfModel::base_color already holds a single colour.
  if (one) return {};
  return out;
}

}  // namespace onggi::content
