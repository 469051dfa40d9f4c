#include "kiosk/collection/content/mesh_parts.h"

#include <cstring>

namespace onggi::content {

namespace {

constexpr char kParts[] = "ONGP", kRefusal[] = "ONGE";

void put(std::vector<std::byte>& out, const void* from, std::size_t size) {
  if (size == 0) return;
  const std::size_t at = out.size();
  out.resize(at + size);
  std::memcpy(out.data() + at, from, size);
}

void put_size(std::vector<std::byte>& out, std::size_t size) {
  const auto narrow = static_cast<std::uint32_t>(size);
  put(out, &narrow, sizeof narrow);
}

/// Reads from the front, and remembers if there was too little.
class Front {
 public:
  explicit Front(std::span<const std::byte> bytes) : rest_(bytes) {}

  std::size_t size() {
    std::uint32_t value = 0;
    take(&value, 1, sizeof value);
    return value;
  }
  template <class Element>
  std::vector<Element> run(std::size_t count) {
    if (count > rest_.size() / sizeof(Element)) whole_ = false;
    std::vector<Element> out(whole_ ? count : 0);
    if (!out.empty()) take(out.data(), out.size(), sizeof(Element));
    return out;
  }
  bool whole() const { return whole_; }
  bool over() const { return rest_.empty(); }

 private:
  void take(void* to, std::size_t count, std::size_t each) {
    if (!whole_ || rest_.size() < count * each) {
      whole_ = false;
      return;
    }
    std::memcpy(to, rest_.data(), count * each);
    rest_ = rest_.subspan(count * each);
  }

  std::span<const std::byte> rest_;
  bool whole_ = true;
};

}  // namespace

std::vector<std::byte> parts_bytes(const std::vector<MeshPart>& parts) {
  std::vector<std::byte> out;
  put(out, kParts, 4);
  put_size(out, parts.size());
  for (const MeshPart& part : parts) {
    put_size(out, part.name.size());
    put_size(out, part.positions.size());
    put_size(out, part.triangles.size());
    put_size(out, part.colors.size());
    put(out, part.name.data(), part.name.size());
    put(out, part.positions.data(), part.positions.size() * sizeof part.positions[0]);
    put(out, part.triangles.data(), part.triangles.size() * sizeof part.triangles[0]);
    put(out, part.colors.data(), part.colors.size() * sizeof part.colors[0]);
  }
  return out;
}

std::vector<std::byte> refusal_bytes(const std::string& why) {
  std::vector<std::byte> out;
  put(out, kRefusal, 4);
  put(out, why.data(), why.size());
  return out;
}

Result<std::vector<MeshPart>> parts_of(std::span<const std::byte> bytes, const std::string& name) {
  const auto begins = [&bytes](const char* word) {
    return bytes.size() >= 4 && std::memcmp(bytes.data(), word, 4) == 0;
  };
  if (begins(kRefusal)) {
    std::string why(reinterpret_cast<const char*>(bytes.data()) + 4, bytes.size() - 4);
    while (!why.empty() && (why.back() == '.' || why.back() == '\n')) why.pop_back();
    return problem(name, "it cannot be read: " + why.substr(0, 300) + ".",
                   "Export the vessel again, best as GLB.");
  }
  const auto none = [&name] {
    return problem(name, "it cannot be read: its reader gave an incomplete answer.",
                   "Export the vessel again, best as GLB.");
  };
  if (!begins(kParts)) return none();
  Front front(bytes.subspan(4));
  std::vector<MeshPart> parts;
  const std::size_t count = front.size();
  for (std::size_t i = 0; i < count && front.whole(); ++i) {
    MeshPart part;
    const std::size_t letters = front.size(), positions = front.size(), triangles = front.size(),
                      colors = front.size();
    const std::vector<char> letter = front.run<char>(letters);
    part.name.assign(letter.begin(), letter.end());
    part.positions = front.run<std::array<float, 3>>(positions);
    part.triangles = front.run<std::array<std::uint32_t, 3>>(triangles);
    part.colors = front.run<std::array<std::uint8_t, 3>>(colors);
    if (!part.colors.empty() && part.colors.size() != part.positions.size()) return none();
    for (const auto& t : part.triangles)
      for (const std::uint32_t corner : t)
        if (corner >= part.positions.size()) return none();
    parts.push_back(std::move(part));
  }
  if (!front.whole() || !front.over()) return none();
  return parts;
}

}  // namespace onggi::content
