#include <cstdint>
#include <cstdlib>
#include <span>

#include "kiosk/collection/content/mesh_parts.h"

// Any bytes are what onggi-mesh answers: it runs Assimp on files of nobody's making in particular,
// so the kiosk believes none of it.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto parts = onggi::content::parts_of(std::as_bytes(std::span(data, size)), "fuzz");
  if (!parts) {
    if (parts.error().what.empty() || parts.error().remedy.empty()) std::abort();
    return 0;
  }
  for (const auto& part : *parts)
    for (const auto& t : part.triangles)
      for (const std::uint32_t corner : t)
        if (corner >= part.positions.size()) std::abort();
  // What was read is written as it was, and reads back alike.
  const auto again = onggi::content::parts_of(onggi::content::parts_bytes(*parts), "fuzz");
  if (!again || again->size() != parts->size()) std::abort();
  return 0;
}
