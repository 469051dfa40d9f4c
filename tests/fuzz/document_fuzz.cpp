#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "kiosk/collection/content/address.h"
#include "kiosk/collection/content/scan_document.h"

// Any bytes are a museum's manifest or document beside a scan.

namespace {

namespace fs = std::filesystem;

/// A folder with a jar.glb, and a file outside that no document may reach.
const fs::path& folder() {
  static const fs::path made = [] {
    const fs::path at = fs::path(access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp") /
                        ("onggi_fuzz_" + std::to_string(getpid()));
    fs::create_directories(at / "inner");
    std::ofstream(at / "inner" / "jar.glb") << "glTF";
    std::ofstream(at / "outside.glb") << "glTF";
    return at;
  }();
  return made;
}

bool printable(const std::string& text) {
  return text.size() <= 1000 && std::none_of(text.begin(), text.end(), [](char c) {
           return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
         });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fs::path file = folder() / "inner" / "manifest.json";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  onggi::content::is_scan_document(file);
  onggi::settings::ReaderLimits limits;
  limits.json_mb = 1;
  limits.json_values = 100'000;
  const auto read = onggi::content::read_scan_document(file, limits);
  if (!read) {
    if (read.error().what.empty() || read.error().remedy.empty()) std::abort();
    return 0;
  }
  if (read->model.parent_path() != folder() / "inner") std::abort();
  const auto& c = read->credit;
  for (const auto& text : {c.title, c.creator, c.copyright, c.licence, c.date, c.description,
                           c.institution, c.accession, c.culture})
    if (!printable(text)) std::abort();
  for (const auto& [language, title] : c.titles)
    if (!printable(title) || language.size() > 3) std::abort();
  if (!c.address.empty() && !onggi::content::fault_of_address(c.address).empty()) std::abort();
  return 0;
}
