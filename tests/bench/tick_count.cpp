// Ticks to be counted, not timed: instructions.py runs this under callgrind, which counts only
// within onggi_counted_ticks().
//   tick_count SCRIPT ROWS SECTORS [KIND]     KIND: of vectors, as engine_trace --kinds lists them
//   tick_count --list                         the scripts' names, a line each
//   tick_count --kinds                        what KIND may be here, a line each
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/support/tick_scripts.h"
#include "tests/support/vector_kinds.h"

namespace {

constexpr int kBefore = 100;  // ticks in which the tool settles, not counted
constexpr int kCounted = 100;

}  // namespace

extern "C" [[gnu::noinline]] void onggi_counted_ticks(onggi::Scene& scene,
                                                      const onggi::TickScript& script) {
  for (int n = kBefore; n < kBefore + kCounted; ++n)
    scene.step(script.hands(n), onggi::kTickSeconds);
}

int main(int argc, char** argv) {
  using namespace onggi;
  const std::string_view word = argc > 1 ? argv[1] : "";
  if (word == "--list") {
    for (const TickScript& script : tick_scripts())
      std::printf("%.*s\n", static_cast<int>(script.name.size()), script.name.data());
    return 0;
  }
  if (word == "--kinds") return print_vector_kinds();
  if (argc < 4 || (argc > 4 && !choose_vectors(argv[4]))) {
    std::fprintf(stderr, "tick_count SCRIPT ROWS SECTORS [KIND], or --list, or --kinds\n");
    return 1;
  }
  const TickScript& script = tick_script(word);
  auto scene = Scene::create(script.scene(std::atoi(argv[2]), std::atoi(argv[3])));
  if (!scene) {
    std::fprintf(stderr, "%s: %s\n", scene.error().where.c_str(), scene.error().what.c_str());
    return 1;
  }
  for (int n = 0; n < kBefore; ++n) scene->step(script.hands(n), kTickSeconds);
  onggi_counted_ticks(*scene, script);
  std::printf("%016llx\n", static_cast<unsigned long long>(scene->state_hash()));
  return 0;
}
