// onggi-texture: the only program that links the picture libraries' readers.
//
//   onggi-texture MOST_SIDE WANTED_SIDE MEMORY_MIB SECONDS < pictures > pixels
//
// The pictures in a scan are untrusted, so they are decoded in their own process with limited
// memory and time and no file but its three streams. texture_answer.h describes its output; the
// kiosk checks every number in it. Exit 0, also if pictures are refused; 1 with the reason on
// standard error.

#include <cstdio>
#include <cstdlib>
#include <new>

#include "kiosk/collection/content/texture_answer.h"
#include "kiosk/collection/textures/texture_decoder.h"
#include "kiosk/ground/files/confined.h"

namespace {

int decode(const onggi::textures::TextureLimits& limits) {
  const auto bytes = onggi::files::standard_input();
  std::vector<onggi::textures::Decoded> decoded;
  for (const auto& picture : onggi::content::pictures_of(bytes)) {
    try {
      decoded.push_back(onggi::textures::decode_texture(picture, limits));
    } catch (const std::bad_alloc&) {
      decoded.push_back(tl::unexpected(std::string("it needs more memory than allowed")));
    }
  }
  const auto out = onggi::content::answer_bytes(decoded);
  const bool written =
      std::fwrite(out.data(), 1, out.size(), stdout) == out.size() && std::fflush(stdout) == 0;
  return written ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) {
    std::fputs("usage: onggi-texture MOST_SIDE WANTED_SIDE MEMORY_MIB SECONDS", stderr);
    return 1;
  }
  const auto number = [words](int i) { return std::strtoul(words[i], nullptr, 10); };
  onggi::files::confine(number(3), number(4), "they take longer than allowed");
  try {
    return decode({static_cast<unsigned>(number(1)), static_cast<unsigned>(number(2))});
  } catch (const std::bad_alloc&) {
    std::fputs("they need more memory than allowed", stderr);
  }
  return 1;
}
