#include "kiosk/ground/files/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/files/files_read.h"

namespace onggi::files {
namespace {

using Kind = ReadFault::Kind;

// Without O_NONBLOCK, opening a pipe that has no writer would wait.
constexpr int kFlags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
constexpr std::size_t kPiece = 65536;

tl::unexpected<ReadFault> fault(Kind kind, int error = 0) {
  return tl::unexpected(ReadFault{kind, 0, error == 0 ? "" : std::strerror(error)});
}

tl::unexpected<ReadFault> not_opened(int error) {
  // No file can have a name that is too long.
  const bool missing = error == ENOENT || error == ENOTDIR || error == ENAMETOOLONG;
  return fault(missing ? Kind::missing : Kind::closed, error);
}

tl::expected<Bytes, ReadFault> read_open(const Descriptor& file, std::size_t most) {
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return fault(Kind::unreadable, errno);
  if (!S_ISREG(info.st_mode)) return fault(S_ISDIR(info.st_mode) ? Kind::folder : Kind::special);
  note_read(info);
  const auto size = static_cast<std::size_t>(info.st_size);
  if (size > most) return tl::unexpected(ReadFault{Kind::too_large, size, ""});
  // Ask for one byte more than the size, so that a growing file is read to its end.
  Bytes bytes(size + 1);
  std::size_t got = 0;
  for (;;) {
    if (got == bytes.size()) bytes.resize(got + kPiece);
    const ssize_t n = ::read(file.get(), bytes.data() + got, bytes.size() - got);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return fault(Kind::unreadable, errno);
    got += static_cast<std::size_t>(n);
    if (got > most) return tl::unexpected(ReadFault{Kind::too_large, got, ""});
    if (n == 0) break;
  }
  bytes.resize(got);
  return bytes;
}

int hex(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percent_decoded(const std::string& uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && hex(uri[i + 1]) >= 0 && hex(uri[i + 2]) >= 0) {
      out += static_cast<char>(hex(uri[i + 1]) * 16 + hex(uri[i + 2]));
      i += 2;
    } else {
      out += uri[i];
    }
  }
  return out;
}

/// The parts between slashes; empty if the path could leave its folder.
std::vector<std::string> inner_parts(const std::string& path) {
  std::vector<std::string> parts;
  if (path.empty() || path.front() == '/' || path.find('\0') != std::string::npos ||
      path.find('\\') != std::string::npos || path.find("://") != std::string::npos)
    return {};
  std::size_t from = 0;
  while (from <= path.size()) {
    const std::size_t slash = std::min(path.find('/', from), path.size());
    const std::string part = path.substr(from, slash - from);
    if (part == "..") return {};
    if (!part.empty() && part != ".") parts.push_back(part);
    from = slash + 1;
  }
  return parts;
}

/// Opens step by step beneath `folder`, so that nobody can insert a link on the way.
Descriptor descend(const std::filesystem::path& folder, const std::vector<std::string>& parts) {
  Descriptor at(::open(folder.empty() ? "." : folder.c_str(), kFlags | O_DIRECTORY));
  for (std::size_t i = 0; at.open() && i < parts.size(); ++i) {
    const int kind = i + 1 < parts.size() ? O_DIRECTORY : 0;
    at = Descriptor(::openat(at.get(), parts[i].c_str(), kFlags | O_NOFOLLOW | kind));
  }
  return at;
}

tl::unexpected<ReadFault> not_beneath(int error) {
  return error == ELOOP || error == ENOTDIR ? fault(Kind::link) : fault(Kind::missing, error);
}

}  // namespace

tl::expected<Bytes, ReadFault> read_file(const std::filesystem::path& file, std::size_t most) {
  const Descriptor opened(::open(file.c_str(), kFlags));
  if (!opened.open()) return not_opened(errno);
  return read_open(opened, most);
}

tl::expected<Bytes, ReadFault> read_beneath(const std::filesystem::path& folder,
                                            const std::string& uri, std::size_t most) {
  const std::vector<std::string> parts = inner_parts(percent_decoded(uri));
  if (parts.empty()) return fault(Kind::outside);
  const Descriptor at = descend(folder, parts);
  if (!at.open()) return not_beneath(errno);
  return read_open(at, most);
}

tl::expected<Descriptor, ReadFault> open_beneath(const std::filesystem::path& folder,
                                                 const std::string& uri) {
  const std::vector<std::string> parts = inner_parts(percent_decoded(uri));
  if (parts.empty()) return fault(Kind::outside);
  Descriptor at = descend(folder, parts);
  if (!at.open()) return not_beneath(errno);
  struct stat found {};
  if (::fstat(at.get(), &found) != 0) return fault(Kind::unreadable, errno);
  if (!S_ISREG(found.st_mode)) return fault(S_ISDIR(found.st_mode) ? Kind::folder : Kind::special);
  return at;
}

tl::expected<std::filesystem::path, ReadFault> find_beneath(const std::filesystem::path& folder,
                                                            const std::string& uri) {
  if (const auto at = open_beneath(folder, uri); !at) return tl::unexpected(at.error());
  std::filesystem::path out = folder;
  for (const std::string& part : inner_parts(percent_decoded(uri))) out /= part;
  return out;
}

}  // namespace onggi::files
