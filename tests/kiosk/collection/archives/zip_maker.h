#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kiosk/ground/files/crc32.h"

namespace onggi::archives::test {

inline constexpr std::uint32_t kFile = 0100644u << 16, kFolder = 0040755u << 16,
                               kLink = 0120777u << 16, kPipe = 0010644u << 16;

/// An entry as an archive may have it; what is not given is as it should be.
struct ZipEntry {
  std::string name, data{};
  std::uint32_t attributes = 0;
  std::uint16_t method = 0, flags = 0;
  std::string packed{};  // where the method is not 0
  std::optional<std::uint32_t> claim{}, crc{};
};

inline std::string little(std::uint64_t value, int length) {
  std::string out;
  for (int n = 0; n < length; ++n) out += static_cast<char>(value >> 8 * n & 255);
  return out;
}

inline std::uint32_t crc_of(const std::string& data) {
  return files::crc32({reinterpret_cast<const std::uint8_t*>(data.data()), data.size()});
}

/// What a local and a central header have in common.
inline std::string head_of(const ZipEntry& entry) {
  const std::string& packed = entry.method == 0 ? entry.data : entry.packed;
  return little(20, 2) + little(entry.flags, 2) + little(entry.method, 2) + little(0, 4) +
         little(entry.crc.value_or(crc_of(entry.data)), 4) + little(packed.size(), 4) +
         little(entry.claim.value_or(static_cast<std::uint32_t>(entry.data.size())), 4) +
         little(entry.name.size(), 2) + little(0, 2);
}

inline std::string end_of(std::uint64_t entries, std::uint64_t length, std::uint64_t at) {
  return "PK\5\6" + little(0, 4) + little(entries, 2) + little(entries, 2) + little(length, 4) +
         little(at, 4) + little(0, 2);
}

inline std::string zip_of(const std::vector<ZipEntry>& entries) {
  std::string out, directory;
  for (const ZipEntry& entry : entries) {
    directory += "PK\1\2" + little(3 << 8 | 20, 2) + head_of(entry) + little(0, 2) + little(0, 4) +
                 little(entry.attributes, 4) + little(out.size(), 4) + entry.name;
    out += "PK\3\4" + head_of(entry) + entry.name + (entry.method == 0 ? entry.data : entry.packed);
  }
  return out + directory + end_of(entries.size(), directory.size(), out.size());
}

/// `count` zeros, deflated by hand: RFC 1951, 3.2.6, a zero and then runs of 258. `count` is one
/// more than a multiple of 258.
inline std::string deflated_zeros(std::size_t count) {
  std::string out;
  unsigned bits = 0, have = 0;
  const auto put = [&](unsigned value, unsigned length, bool code) {
    // The codes begin with their highest bit, all else with the lowest.
    for (unsigned n = 0; n < length; ++n) {
      bits |= (value >> (code ? length - 1 - n : n) & 1) << have;
      if (++have == 8) out += static_cast<char>(bits), bits = have = 0;
    }
  };
  put(1, 1, false), put(1, 2, false), put(0x30, 8, true);
  for (std::size_t n = 1; n < count; n += 258) put(0xC5, 8, true), put(0, 5, true);
  put(0, 7, true), put(0, 7, false);
  return out;
}

inline void write_zip(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace onggi::archives::test
