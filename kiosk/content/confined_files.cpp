#include "kiosk/content/confined_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace onggi::content {

namespace {

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }
  bool open() const { return fd_ >= 0; }

 private:
  int fd_;
};

// O_NONBLOCK: opening a pipe without a writer must not wait for one.
constexpr int kFlags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;

Result<Bytes> read_open_file(const Descriptor& file, const std::string& name, std::size_t most) {
  struct stat info {};
  if (::fstat(file.get(), &info) != 0 || !S_ISREG(info.st_mode))
    return problem(name, "it is not a regular file.", "Name a file, not a folder or a device.");
  const auto size = static_cast<std::size_t>(info.st_size);
  if (size > most)
    return problem(name,
                   "it has " + std::to_string(size >> 20) + " MiB, and the most is " +
                       std::to_string(most >> 20) + " MiB.",
                   "Export the vessel with fewer triangles.");
  Bytes bytes(size);
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got = ::read(file.get(), bytes.data() + done, size - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0)
      return problem(name, std::string("it cannot be read: ") + std::strerror(errno) + ".",
                     "Check the disk and the file's permissions.");
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
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

/// Parts between slashes; empty where the path could leave its folder.
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

}  // namespace

Result<Bytes> read_regular_file(const std::filesystem::path& file, std::size_t most) {
  const Descriptor opened(::open(file.c_str(), kFlags));
  if (!opened.open())
    return problem(file.string(), std::string("it cannot be opened: ") + std::strerror(errno) + ".",
                   "Check the name and that the kiosk may read it.");
  return read_open_file(opened, file.string(), most);
}

Result<Bytes> read_beneath(const std::filesystem::path& folder, const std::string& uri,
                           std::size_t most, const std::string& name) {
  const std::vector<std::string> parts = inner_parts(percent_decoded(uri));
  const std::string shown = uri.substr(0, 80);
  if (parts.empty())
    return problem(name, "it asks for \"" + shown + "\", which is not beneath its own folder.",
                   "Put every file of the vessel into its folder, or export it as one GLB.");
  Descriptor at(::open(folder.empty() ? "." : folder.c_str(), kFlags | O_DIRECTORY));
  for (std::size_t i = 0; at.open() && i < parts.size(); ++i) {
    const int kind = i + 1 < parts.size() ? O_DIRECTORY : 0;
    at = Descriptor(::openat(at.get(), parts[i].c_str(), kFlags | O_NOFOLLOW | kind));
  }
  if (!at.open()) {
    if (errno == ELOOP || errno == ENOTDIR)
      return problem(name, "it asks for \"" + shown + "\", which goes through a symbolic link.",
                     "Put the file itself into the vessel's folder.");
    return problem(name, "its file \"" + shown + "\" is missing: " + std::strerror(errno) + ".",
                   "Put the file beside it, or export the vessel as one GLB.");
  }
  auto bytes = read_open_file(at, name + ", file \"" + shown + "\"", most);
  return bytes;
}

}  // namespace onggi::content
