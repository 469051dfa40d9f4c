// One program of the determinism matrix (matrix.py, engine/docs/determinism.md):
//   engine_trace [--seconds N] [--vectors KIND]   the trace's hashes, a line a second
//   engine_trace --tools [--vectors KIND]         of every tool and effect, a line a tool
//   engine_trace --hard [--vectors KIND]          of random hands in random scenes
//   engine_trace --handle                         of what a force device is given
//   engine_trace --kinds                          what KIND may be here, a line each
//   engine_trace --libm                           a hash of libm's own sin, exp, pow and atan2
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "engine/math/hash.h"
#include "tests/support/engine_trace.h"
#include "tests/support/hard_trace.h"
#include "tests/support/vector_kinds.h"

namespace {

// The engine calls none of these. Where the bits differ, libm took another way.
int print_libm() {
  onggi::StateHash hash;
  for (int n = 1; n < 20000; ++n) {
    const volatile double x = n * 0.00137;
    for (double y : {std::sin(x), std::exp(0.1 * x), std::pow(x, 1.3), std::atan2(x, 2.0)})
      hash.add(std::bit_cast<std::uint64_t>(y));
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(hash.value()));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  int seconds = 6;
  std::string_view which;
  std::optional<onggi::Vectors> kind = onggi::best_vectors();
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    const char* value = k + 1 < argc ? argv[k + 1] : nullptr;
    if (word == "--kinds") return onggi::print_vector_kinds();
    if (word == "--libm") return print_libm();
    if (word == "--tools" || word == "--hard" || word == "--handle") {
      which = word;
      continue;
    }
    if (word == "--seconds" && value != nullptr) {
      seconds = std::atoi(value);
      ++k;
    } else if (word == "--vectors" && value != nullptr) {
      kind = onggi::choose_vectors(value);
      if (!kind) return 1;
      ++k;
    } else {
      std::fprintf(stderr, "engine_trace does not know \"%s\".\n", argv[k]);
      return 1;
    }
  }
  const std::string hashes = which == "--tools"    ? onggi::tools_trace(*kind)
                             : which == "--hard"   ? onggi::hard_trace(*kind)
                             : which == "--handle" ? onggi::handle_trace()
                                                   : onggi::engine_trace(seconds, *kind);
  std::fputs(hashes.c_str(), stdout);
  return hashes.empty() ? 1 : 0;
}
