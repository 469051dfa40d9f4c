#include "kiosk/content/gltf_container.h"

#include <utility>

#include "kiosk/content/glb.h"

namespace onggi::content {

namespace {

std::uint32_t u32_at(const files::Bytes& bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
         static_cast<std::uint32_t>(bytes[at + 2]) << 16 |
         static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

Result<GltfContainer> split(const std::string& name, const files::Bytes& bytes) {
  GltfContainer out;
  if (bytes.size() < 4 || u32_at(bytes, 0) != kGlbMagic) {
    out.json.assign(bytes.begin(), bytes.end());
    return out;
  }
  if (bytes.size() < 20) return broken_gltf(name, "this GLB ends within its header.");
  if (u32_at(bytes, 4) != 2)
    return broken_gltf(name, "this GLB is of version " + std::to_string(u32_at(bytes, 4)) +
                                 ", and 2 is what can be read.");
  const std::size_t total = u32_at(bytes, 8);
  if (total > bytes.size())
    return broken_gltf(name, "this GLB says it has " + std::to_string(total) + " bytes, and has " +
                                 std::to_string(bytes.size()) + ".");
  std::size_t at = 12;
  for (int chunk = 0; at + 8 <= total; ++chunk) {
    const std::size_t length = u32_at(bytes, at);
    const std::uint32_t kind = u32_at(bytes, at + 4);
    at += 8;
    if (length > total - at) return broken_gltf(name, "a chunk of this GLB runs over its end.");
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto last = first + static_cast<std::ptrdiff_t>(length);
    if (chunk == 0 && kind != kGlbJson)
      return broken_gltf(name, "the first chunk of this GLB is not JSON.");
    if (chunk == 0) out.json.assign(first, last);
    if (chunk == 1 && kind == kGlbBin) out.bin = files::Bytes(first, last);
    at += length;
  }
  return out;
}

/// Size, depth and number of values before any parser with a stack or a heap meets them.
Result<void> measure_json(const std::string& name, const std::string& text,
                          const settings::ReaderLimits& limits) {
  const auto most = static_cast<std::size_t>(limits.json_mb) << 20;
  if (text.size() > most)
    return broken_gltf(name, "its JSON has " + std::to_string(text.size() >> 20) +
                                 " MiB, and the most is " + std::to_string(limits.json_mb) + ".");
  int depth = 0, values = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
      continue;
    }
    if (c == '"') quoted = true;
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (c == '{' || c == '[' || c == ',' || c == ':') ++values;
    if (depth > limits.json_depth)
      return broken_gltf(
          name, "its JSON is nested more than " + std::to_string(limits.json_depth) + " deep.");
    if (values > limits.json_values)
      return broken_gltf(
          name, "its JSON has more than " + std::to_string(limits.json_values) + " values.");
  }
  return {};
}

}  // namespace

tl::unexpected<Problem> broken_gltf(const std::string& name, std::string what) {
  return problem(name, std::move(what),
                 "Export it again as glTF 2.0 (GLB); it may have been cut off on the way.");
}

Result<GltfContainer> split_gltf(const std::string& name, const files::Bytes& bytes,
                                 const settings::ReaderLimits& limits) {
  auto container = split(name, bytes);
  if (!container) return container;
  if (auto good = measure_json(name, container->json, limits); !good)
    return tl::unexpected<Problem>(good.error());
  return container;
}

}  // namespace onggi::content
