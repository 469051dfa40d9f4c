#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "kiosk/collection/archives/unpack.h"

// Any bytes are an archive. What comes out lies in its folder, is no more than the limits allow and
// no link; what is refused leaves nothing.

namespace {

namespace fs = std::filesystem;

/// A folder with a folder in it, so that a name that leads out is seen.
const fs::path& place() {
  static const fs::path made = [] {
    const fs::path at = fs::path(access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp") /
                        ("onggi_fuzz_" + std::to_string(getpid()));
    fs::create_directories(at / "inner");
    return at;
  }();
  return made;
}

void check(const fs::path& folder, const onggi::archives::UnpackLimits& limits) {
  std::uint64_t bytes = 0;
  for (const auto& at : fs::recursive_directory_iterator(folder)) {
    const fs::file_type type = at.symlink_status().type();
    if (type != fs::file_type::regular && type != fs::file_type::directory) std::abort();
    if (type == fs::file_type::regular) bytes += at.file_size();
  }
  if (bytes > limits.bytes) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fs::path inner = place() / "inner", file = inner / "scan.zip", folder = inner / "folder";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  const onggi::archives::UnpackLimits limits{
      .entries = 50, .bytes = 1u << 20, .depth = 8, .reserve = 0};
  const auto done = onggi::archives::unpack(file, folder, limits);
  if (fs::exists(folder) != done.has_value()) std::abort();
  if (done)
    check(folder, limits);
  else if (done.error().what.empty() || done.error().remedy.empty())
    std::abort();
  fs::remove_all(folder);
  // The archive and its folder, and nothing beside them.
  if (std::distance(fs::directory_iterator(inner), {}) != 1 ||
      std::distance(fs::directory_iterator(place()), {}) != 1)
    std::abort();
  return 0;
}
