#include "kiosk/collection/content/gltf_container.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "kiosk/collection/content/data_uri.h"
#include "kiosk/collection/content/glb.h"
#include "kiosk/collection/content/vessel_file.h"

namespace onggi::content {

namespace {

std::uint32_t u32_at(const files::Bytes& bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
         static_cast<std::uint32_t>(bytes[at + 2]) << 16 |
         static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

/// Where JSON and BIN lie in the file.
struct Chunks {
  ByteRange json;
  std::optional<ByteRange> bin;
};

Result<Chunks> split(const std::string& name, const files::Bytes& bytes) {
  if (bytes.size() < 4 || u32_at(bytes, 0) != kGlbMagic) return Chunks{{0, bytes.size()}, {}};
  if (bytes.size() < 20) return broken_gltf(name, "this GLB ends within its header.");
  if (u32_at(bytes, 4) != 2)
    return broken_gltf(name, "this GLB is of version " + std::to_string(u32_at(bytes, 4)) +
                                 ", but Onggi reads version 2.");
  const std::size_t total = u32_at(bytes, 8);
  if (total > bytes.size())
    return broken_gltf(name, "this GLB says it has " + std::to_string(total) +
                                 " bytes, but it has " + std::to_string(bytes.size()) + ".");
  Chunks out;
  std::size_t at = 12;
  for (int chunk = 0; at + 8 <= total; ++chunk) {
    const std::size_t length = u32_at(bytes, at);
    const std::uint32_t kind = u32_at(bytes, at + 4);
    at += 8;
    if (length > total - at) return broken_gltf(name, "a chunk of this GLB extends past its end.");
    if (chunk == 0 && kind != kGlbJson)
      return broken_gltf(name, "the first chunk of this GLB is not JSON.");
    if (chunk == 0) out.json = {at, length};
    if (chunk == 1 && kind == kGlbBin) out.bin = ByteRange{at, length};
    at += length;
  }
  return out;
}

/// Copies JSON without its data URIs and counts its values, before a parser can use up stack or
/// heap.
class JsonSieve {
 public:
  JsonSieve(const std::string& name, const files::Bytes& bytes, ByteRange text,
            const settings::ReaderLimits& limits)
      : name_(name),
        bytes_(bytes),
        at_(text.at),
        end_(text.at + text.length),
        limits_(limits),
        most_(static_cast<std::size_t>(limits.json_mb) << 20) {}

  Result<void> run(GltfContainer& out) {
    while (at_ < end_) {
      const unsigned char c = bytes_[at_];
      if (c == '"') {
        if (auto good = string(out); !good) return good;
        continue;
      }
      if (c == '{' || c == '[') ++depth_;
      if (c == '}' || c == ']') --depth_;
      if (c == '{' || c == '[' || c == ',' || c == ':') ++values_;
      if (depth_ > limits_.json_depth)
        return tl::unexpected(beyond_limit(
            name_, "its JSON is nested " + std::to_string(depth_) + " deep or deeper",
            std::to_string(limits_.json_depth), "json_depth", "Export the vessel again"));
      if (values_ > limits_.json_values)
        return tl::unexpected(beyond_limit(
            name_, "its JSON has " + std::to_string(values_) + " values or more",
            std::to_string(limits_.json_values), "json_values", "Export the vessel alone"));
      if (auto good = copy(at_, at_ + 1, out); !good) return good;
      ++at_;
    }
    return {};
  }

 private:
  /// Reads from one quote to behind the other, or to the end if there is none.
  Result<void> string(GltfContainer& out) {
    const std::size_t from = at_ + 1;
    std::size_t to = from;
    while (to < end_ && bytes_[to] != '"') to += bytes_[to] == '\\' ? 2 : 1;
    to = std::min(to, end_);
    const ByteRange inside{from, to - from};
    const std::size_t behind = std::min(to + 1, end_);
    if (to < end_ && is_data_uri(std::span(bytes_).subspan(inside.at, inside.length))) {
      out.json += "\"data:#" + std::to_string(out.data.size()) + "\"";
      out.data.push_back(inside);
    } else if (auto good = copy(at_, behind, out); !good) {
      return good;
    }
    at_ = behind;
    return {};
  }

  Result<void> copy(std::size_t from, std::size_t to, GltfContainer& out) {
    if (out.json.size() + (to - from) > most_)
      return tl::unexpected(beyond_limit(
          name_, "its JSON has " + std::to_string((end_ - at_ + out.json.size()) >> 20) + " MiB",
          std::to_string(limits_.json_mb) + " MiB", "json_mb", "Export the vessel as GLB"));
    out.json.append(reinterpret_cast<const char*>(bytes_.data()) + from, to - from);
    return {};
  }

  const std::string& name_;
  const files::Bytes& bytes_;
  std::size_t at_;
  const std::size_t end_;
  const settings::ReaderLimits& limits_;
  const std::size_t most_;
  int depth_ = 0, values_ = 0;
};

}  // namespace

std::optional<std::size_t> data_behind(const std::string& uri, const GltfContainer& container) {
  constexpr std::string_view kMark = "data:#";
  if (uri.rfind(kMark, 0) != 0) return std::nullopt;
  std::size_t number = 0;
  const char* const end = uri.data() + uri.size();
  const auto read = std::from_chars(uri.data() + kMark.size(), end, number);
  if (read.ec != std::errc() || read.ptr != end || number >= container.data.size())
    return std::nullopt;
  return number;
}

tl::unexpected<Problem> broken_gltf(const std::string& name, std::string what) {
  return problem(name, std::move(what),
                 "Export it again as glTF 2.0 (GLB); it may have been cut off on the way.");
}

Result<GltfContainer> split_gltf(const std::string& name, const files::Bytes& bytes,
                                 const settings::ReaderLimits& limits) {
  const auto chunks = split(name, bytes);
  if (!chunks) return tl::unexpected<Problem>(chunks.error());
  Result<GltfContainer> out;
  out->bin = chunks->bin;
  if (auto good = JsonSieve(name, bytes, chunks->json, limits).run(*out); !good)
    return tl::unexpected<Problem>(good.error());
  return out;
}

}  // namespace onggi::content
