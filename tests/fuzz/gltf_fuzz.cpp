#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "engine/profile/extraction.h"
#include "kiosk/collection/content/gltf_parts.h"

// libFuzzer feeds any bytes to the reader as a file of its own folder, and a model that comes out
// to the extraction. tests/fuzz/run builds and runs it; what it finds is kept in tests/fuzz/found.

namespace {

/// Small enough that a claim of more is refused and not served.
onggi::settings::ReaderLimits limits() {
  onggi::settings::ReaderLimits out;
  out.file_mb = 64;
  out.json_mb = 4;
  out.json_values = 100'000;
  out.vertices = 300'000;
  out.triangles = 300'000;
  out.texture_px = 0;  // no process for each input: texture_fuzz has the pictures
  return out;
}

const std::string& file_name() {
  static const std::string name =
      (access("/dev/shm", W_OK) == 0 ? "/dev/shm/onggi_fuzz_" : "/tmp/onggi_fuzz_") +
      std::to_string(getpid()) + ".gltf";
  return name;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::FILE* file = std::fopen(file_name().c_str(), "wb");
  if (file == nullptr) return 0;
  const bool written = std::fwrite(data, 1, size, file) == size;
  std::fclose(file);
  if (!written) return 0;
  const auto model = onggi::content::read_gltf(file_name(), limits());
  if (!model) {
    // What is refused is refused with a meaning and a remedy.
    if (model.error().what.empty() || model.error().remedy.empty()) std::abort();
    return 0;
  }
  for (const auto& t : model->mesh.triangles)
    for (const std::uint32_t corner : t)
      if (corner >= model->mesh.positions.size()) std::abort();
  for (const auto& part : model->parts)
    for (const auto reach : {onggi::content::Reach::alone, onggi::content::Reach::all})
      onggi::content::mesh_of(*model, part, reach);
  onggi::content::separate_objects(*model);
  if (model->mesh.triangles.size() > 20'000) return 0;
  const auto found = onggi::extract_profile(model->mesh, {}, "fuzz");
  if (found && !onggi::validate(found->profile, "fuzz")) std::abort();
  return 0;
}
