#include "kiosk/keepsake/souvenir/stl.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "kiosk/ground/files/byte_writer.h"

namespace onggi::souvenir {
namespace {

using Point = std::array<float, 3>;
using nlohmann::json;

constexpr std::uint32_t kGlb = 0x46546C67, kJson = 0x4E4F534A, kBin = 0x004E4942;  // glTF 2.0, 4.4
constexpr int kShort = 5123, kFloat = 5126, kInt = 5125;                           // and 5.1
constexpr std::uint64_t kMostJson = 1u << 20, kMostPositions = 1u << 20, kMostTriangles = 1u << 21;
constexpr std::size_t kTriangle = 50, kLetters = 80, kPoint = 12;

bool read_at(const files::Descriptor& file, std::uint64_t at, void* into, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t n = ::pread(file.get(), static_cast<char*>(into) + done, size - done,
                              static_cast<off_t>(at + done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

/// A little-endian number.
std::uint32_t number(const std::byte* bytes, std::size_t count) {
  std::uint32_t sum = 0;
  for (std::size_t n = 0; n < count; ++n)
    sum |= std::to_integer<std::uint32_t>(bytes[n]) << (8 * n);
  return sum;
}

/// Metres with y up to millimetres with z up: a quarter turn about x, which keeps the outside
/// outside.
Point to_printer(const std::byte* at) {
  const auto coordinate = [at](std::size_t k) {
    return std::bit_cast<float>(number(at + 4 * k, 4));
  };
  // Adding 0 turns -0 into 0, so that equal positions have equal bytes.
  return {coordinate(0) * 1000.0f + 0.0f, -coordinate(2) * 1000.0f + 0.0f,
          coordinate(1) * 1000.0f + 0.0f};
}

Point unit_normal(const Point& a, const Point& b, const Point& c) {
  const auto edge = [](const Point& from, const Point& to, std::size_t k) {
    return static_cast<double>(to[k]) - static_cast<double>(from[k]);
  };
  std::array<double, 3> n{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    n[k] = edge(a, b, i) * edge(a, c, j) - edge(a, b, j) * edge(a, c, i);
  }
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0.0)) return {0, 0, 0};  // a sliver: slicers compute it themselves
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
          static_cast<float>(n[2] / length)};
}

/// A triangle as it stands in the file.
void put_triangle(const std::array<Point, 3>& face, std::span<std::byte> into) {
  files::ByteWriter out(kTriangle);
  out.f32s(unit_normal(face[0], face[1], face[2]));
  for (const Point& point : face) out.f32s(point);
  out.u16(0);
  std::ranges::copy(out.bytes(), into.begin());
}

/// The letters that an STL begins with. They must not be "solid": readers would take it for the
/// text form.
std::string letters_of(const std::string& title) {
  std::string letters = "Onggi, mm, z up: " + title;
  std::size_t end = std::min(letters.size(), kLetters);
  while (end < letters.size() && (static_cast<unsigned char>(letters[end]) & 0xC0) == 0x80) --end;
  letters.resize(end);
  letters.resize(kLetters, ' ');
  return letters;
}

/// Where an accessor's elements begin in the BIN chunk. Throws json::exception for any other GLB.
std::uint64_t offset_of(const json& document, const json& accessor) {
  const json& view = document.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
  return view.value("byteOffset", std::uint64_t{0}) +
         accessor.value("byteOffset", std::uint64_t{0});
}

}  // namespace

std::optional<StlOfPot> StlOfPot::of(const files::Descriptor& file) {
  auto relief = ReliefStl::of(file);
  if (!relief) return of_glb(file);
  StlOfPot stl;
  stl.begin(relief->title(), relief->triangles());
  stl.relief_ = std::move(relief);
  return stl;
}

void StlOfPot::begin(const std::string& title, std::uint64_t triangles) {
  const std::string letters = letters_of(title);
  std::memcpy(head_.data(), letters.data(), kLetters);
  for (std::size_t n = 0; n < 4; ++n)
    head_[kLetters + n] = static_cast<std::byte>(triangles >> (8 * n));
}

std::optional<StlOfPot> StlOfPot::of_glb(const files::Descriptor& glb) {
  std::array<std::byte, 20> begin{};
  if (!read_at(glb, 0, begin.data(), begin.size()) || number(begin.data(), 4) != kGlb ||
      number(&begin[16], 4) != kJson)
    return {};
  const std::uint64_t length = number(&begin[12], 4);
  std::array<std::byte, 8> chunk{};
  if (length > kMostJson || !read_at(glb, begin.size() + length, chunk.data(), chunk.size()) ||
      number(&chunk[4], 4) != kBin)
    return {};
  const std::uint64_t bin = begin.size() + length + chunk.size(), bytes = number(chunk.data(), 4);
  struct stat info {};
  if (::fstat(glb.get(), &info) != 0 || static_cast<std::uint64_t>(info.st_size) < bin + bytes)
    return {};
  std::string text(static_cast<std::size_t>(length), ' ');
  if (!read_at(glb, begin.size(), text.data(), text.size())) return {};

  StlOfPot stl;
  std::uint64_t all = 0;
  const json document = json::parse(text, nullptr, false);
  try {
    const json& accessors = document.at("accessors");
    const json& mesh = document.at("meshes").at(0);
    const json& primitives = mesh.at("primitives");
    const json& corners =
        accessors.at(primitives.at(0).at("attributes").at("POSITION").get<std::size_t>());
    stl.count_ = corners.at("count").get<std::uint64_t>();
    const std::uint64_t at = offset_of(document, corners);
    if (corners.at("componentType") != kFloat || stl.count_ > kMostPositions || at > bytes ||
        kPoint * stl.count_ > bytes - at)
      return {};
    stl.positions_ = bin + at;
    for (const json& primitive : primitives) {
      const json& indices = accessors.at(primitive.at("indices").get<std::size_t>());
      const int type = indices.at("componentType").get<int>();
      Part part;
      part.index_bytes = type == kShort ? 2 : 4;
      const auto count = indices.at("count").get<std::uint64_t>();
      part.triangles = count / 3;
      part.at = offset_of(document, indices);
      if ((type != kShort && type != kInt) || count > 3 * kMostTriangles || part.at > bytes ||
          count * part.index_bytes > bytes - part.at)
        return {};
      part.at += bin;
      all += part.triangles;
      stl.parts_.push_back(part);
    }
    stl.begin(mesh.value("name", std::string()), all);
  } catch (const json::exception&) {
    return {};
  }
  if (all > kMostTriangles) return {};
  return stl;
}

std::uint64_t StlOfPot::size() const {
  std::uint64_t size = kHead;
  if (relief_) size += kTriangle * relief_->triangles();
  for (const Part& part : parts_) size += kTriangle * part.triangles;
  return size;
}

bool StlOfPot::triangles(const files::Descriptor& glb, const Part& part, std::uint64_t first,
                         std::span<std::byte> into) const {
  const std::size_t corners = 3 * (into.size() / kTriangle);
  std::vector<std::byte> indices(corners * part.index_bytes);
  if (!read_at(glb, part.at + 3 * first * part.index_bytes, indices.data(), indices.size()))
    return false;
  const auto corner = [&](std::size_t n) {
    return number(&indices[n * part.index_bytes], part.index_bytes);
  };
  // Neighbouring triangles have neighbouring corners, so these are few.
  std::uint32_t low = corner(0), high = low;
  for (std::size_t n = 1; n < corners; ++n) {
    low = std::min(low, corner(n));
    high = std::max(high, corner(n));
  }
  if (high >= count_) return false;
  std::vector<std::byte> positions(kPoint * (high - low + 1));
  if (!read_at(glb, positions_ + kPoint * low, positions.data(), positions.size())) return false;
  for (std::size_t n = 0; n < corners; n += 3) {
    std::array<Point, 3> face;
    for (std::size_t k = 0; k < 3; ++k)
      face[k] = to_printer(&positions[kPoint * (corner(n + k) - low)]);
    put_triangle(face, into.subspan(n / 3 * kTriangle, kTriangle));
  }
  return true;
}

bool StlOfPot::relief_triangles(const files::Descriptor& file, std::uint64_t first,
                                std::span<std::byte> into) const {
  std::vector<ReliefStl::Triangle> faces(into.size() / kTriangle);
  if (!relief_->read(file, first, faces)) return false;
  for (std::size_t n = 0; n < faces.size(); ++n)
    put_triangle(faces[n], into.subspan(n * kTriangle, kTriangle));
  return true;
}

bool StlOfPot::read(const files::Descriptor& file, std::uint64_t from,
                    std::span<std::byte> into) const {
  const std::uint64_t to = from + into.size();
  if (to > size()) return false;
  if (from < kHead) {
    const auto some = std::span(head_).subspan(static_cast<std::size_t>(from));
    std::ranges::copy(some.first(std::min(some.size(), into.size())), into.begin());
  }
  std::uint64_t begin = kHead;  // of the part
  // Of `count` triangles that follow, those within the span.
  const auto some_of = [&](std::uint64_t count, const auto& made) {
    const std::uint64_t end = begin + kTriangle * count;
    const std::uint64_t wanted = std::max(begin, from), until = std::min(end, to);
    if (wanted < until) {
      const std::uint64_t first = (wanted - begin) / kTriangle;
      const std::uint64_t last = (until - begin + kTriangle - 1) / kTriangle;
      std::vector<std::byte> whole(static_cast<std::size_t>(kTriangle * (last - first)));
      if (!made(first, std::span(whole))) return false;
      const auto skipped = static_cast<std::size_t>(wanted - begin - kTriangle * first);
      std::ranges::copy(std::span(whole).subspan(skipped, static_cast<std::size_t>(until - wanted)),
                        into.begin() + static_cast<std::ptrdiff_t>(wanted - from));
    }
    begin = end;
    return true;
  };
  if (relief_)
    return some_of(relief_->triangles(), [&](std::uint64_t first, std::span<std::byte> whole) {
      return relief_triangles(file, first, whole);
    });
  for (const Part& part : parts_)
    if (!some_of(part.triangles, [&](std::uint64_t first, std::span<std::byte> whole) {
          return triangles(file, part, first, whole);
        }))
      return false;
  return true;
}

}  // namespace onggi::souvenir
