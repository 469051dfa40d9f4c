// onggi-texture: the only program that links the picture libraries' readers.
//
//   onggi-texture MOST_SIDE WANTED_SIDE MEMORY_MIB SECONDS < pictures > pixels
//
// The pictures in a scan are of nobody's making in particular, so they are decoded in a process of
// their own, with no more memory and time than it is given and no file but its three streams. What
// it writes is told in texture_answer.h; the kiosk checks every number of it. Exit 0, also where
// pictures are refused; 1 with the reason on standard error.

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "kiosk/content/texture_answer.h"
#include "kiosk/textures/texture_decoder.h"

namespace {

// Sanitizers' shadow memory is larger than any limit, and they look into /proc and pipes. gcc and
// clang tell of them each in its way.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kSanitized = false;
#endif

void say_that_time_is_over(int) {
  constexpr char kWords[] = "they take longer than they may";
  const ssize_t written = write(STDERR_FILENO, kWords, sizeof kWords - 1);
  _exit(written < 0 ? 2 : 1);
}

void confine(rlim_t memory_mib, rlim_t seconds) {
  const auto limit = [](auto what, rlim_t most, rlim_t after = 0) {
    const rlimit both{most, most + after};
    return setrlimit(what, &both) == 0;
  };
  std::signal(SIGXCPU, say_that_time_is_over);
  bool good = limit(RLIMIT_CPU, seconds, 1) && limit(RLIMIT_CORE, 0) && limit(RLIMIT_FSIZE, 0);
  if (!kSanitized) good = good && limit(RLIMIT_NOFILE, 3) && limit(RLIMIT_AS, memory_mib << 20);
  if (good) return;
  std::fputs("the limits of memory and time could not be set", stderr);
  std::exit(1);
}

std::vector<std::uint8_t> standard_input() {
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 1 << 16> block;
  for (std::size_t n; (n = std::fread(block.data(), 1, block.size(), stdin)) > 0;)
    bytes.insert(bytes.end(), block.data(), block.data() + n);
  return bytes;
}

int decode(const onggi::textures::TextureLimits& limits) {
  const std::vector<std::uint8_t> bytes = standard_input();
  std::vector<onggi::textures::Decoded> decoded;
  for (const auto& picture : onggi::content::pictures_of(bytes)) {
    try {
      decoded.push_back(onggi::textures::decode_texture(picture, limits));
    } catch (const std::bad_alloc&) {
      decoded.push_back(tl::unexpected(std::string("it needs more memory than it may have")));
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
  confine(number(3), number(4));
  try {
    return decode({static_cast<unsigned>(number(1)), static_cast<unsigned>(number(2))});
  } catch (const std::bad_alloc&) {
    std::fputs("they need more memory than they may have", stderr);
  }
  return 1;
}
