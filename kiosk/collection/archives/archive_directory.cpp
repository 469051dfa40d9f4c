#include "kiosk/collection/archives/archive_directory.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/ground/files/descriptor.h"

namespace onggi::archives {

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<unsigned char>;

// PKWARE's APPNOTE.TXT, sections 4.3.12 to 4.3.16: the records, and their lengths without names.
constexpr std::uint32_t kEntry = 0x02014b50, kEnd = 0x06054b50, kFarEnd = 0x06064b50,
                        kLocator = 0x07064b50;
constexpr std::size_t kEntryLength = 46, kEndLength = 22, kFarEndLength = 56, kLocatorLength = 20;
constexpr std::size_t kMostOfAComment = 65535;
constexpr std::size_t kMostOfAnEntry = 2048;  // bytes in the directory, on average
// An archive in an archive, at its end, shows one of its own.
constexpr std::size_t kMostEnds = 8;

std::uint64_t number(const Bytes& bytes, std::size_t at, std::size_t length) {
  std::uint64_t value = 0;
  for (std::size_t n = length; n-- > 0;) value = value << 8 | bytes[at + n];
  return value;
}

/// `length` bytes of `file` from `at` on; fewer where it ends or cannot be read.
Bytes read_at(int file, std::uint64_t at, std::size_t length) {
  Bytes bytes(length);
  std::size_t have = 0;
  while (have < length) {
    const ssize_t n =
        ::pread(file, bytes.data() + have, length - have, static_cast<off_t>(at + have));
    if (n <= 0) break;
    have += static_cast<std::size_t>(n);
  }
  bytes.resize(have);
  return bytes;
}

/// What an end record claims of the directory.
struct Claim {
  std::uint64_t entries = 0, length = 0, at = 0;
};

/// The claims of each record in the file's last bytes that may be its end.
std::vector<Claim> claims_in(int file, std::uint64_t size) {
  const auto length = static_cast<std::size_t>(
      std::min<std::uint64_t>(size, kMostOfAComment + kEndLength + kLocatorLength));
  const Bytes tail = read_at(file, size - length, length);
  std::vector<Claim> claims;
  for (std::size_t at = 0; at + kEndLength <= tail.size() && claims.size() <= kMostEnds; ++at) {
    if (number(tail, at, 4) != kEnd) continue;
    claims.push_back(
        {number(tail, at + 10, 2), number(tail, at + 12, 4), number(tail, at + 16, 4)});
    if (at < kLocatorLength || number(tail, at - kLocatorLength, 4) != kLocator) continue;
    const Bytes far = read_at(file, number(tail, at - kLocatorLength + 8, 8), kFarEndLength);
    if (far.size() == kFarEndLength && number(far, 0, 4) == kFarEnd)
      claims.push_back({number(far, 32, 8), number(far, 40, 8), number(far, 48, 8)});
  }
  return claims;
}

/// Entries of the directory `bytes`; nothing where a name has a zero byte.
std::optional<std::size_t> entries_in(const Bytes& bytes) {
  std::size_t count = 0;
  for (std::size_t at = 0; at + kEntryLength <= bytes.size(); ++count) {
    if (number(bytes, at, 4) != kEntry) break;
    const auto name = static_cast<std::size_t>(number(bytes, at + 28, 2));
    const auto rest =
        static_cast<std::size_t>(number(bytes, at + 30, 2) + number(bytes, at + 32, 2));
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at + kEntryLength);
    const auto end =
        begin + std::min(static_cast<std::ptrdiff_t>(name), std::distance(begin, bytes.end()));
    if (std::find(begin, end, 0) != end) return {};
    at += kEntryLength + name + rest;
  }
  return count;
}

tl::unexpected<Problem> too_many(const std::string& where, std::size_t most) {
  return problem(where,
                 "this archive has more than " + std::to_string(most) + " files and folders.",
                 "Make an archive of the scan's own files alone.");
}

}  // namespace

Result<void> check_directory(const fs::path& file, std::size_t most) {
  const std::string where = file.string();
  const files::Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat info {};
  if (!in.open() || ::fstat(in.get(), &info) != 0 || !S_ISREG(info.st_mode))
    return problem(where, "this archive is not there, or cannot be read.",
                   "Check the name, and that you may read the file.");
  const auto size = static_cast<std::uint64_t>(info.st_size);
  const std::vector<Claim> claims = claims_in(in.get(), size);
  if (claims.empty() || claims.size() > kMostEnds)
    return problem(where, "this is no zip archive, or its end is missing.",
                   "Make the archive again, and copy all of it.");
  for (const Claim& claim : claims) {
    if (claim.entries > most || claim.length > most * kMostOfAnEntry) return too_many(where, most);
    if (claim.at >= size) continue;
    const auto entries = entries_in(
        read_at(in.get(), claim.at,
                static_cast<std::size_t>(std::min<std::uint64_t>(claim.length, size - claim.at))));
    if (!entries)
      return problem(where, "a name in this archive has a zero byte.",
                     "Make the archive again with this computer's own zip program.");
    if (*entries > most) return too_many(where, most);
  }
  return {};
}

}  // namespace onggi::archives
