// Ticks to be counted, not timed: instructions.py runs this under callgrind, which counts only
// within onggi_counted_ticks().
//   tick_count SCRIPT ROWS SECTORS [KIND [EFFECTS]]
//                                             KIND: of vectors, as engine_trace --kinds lists them
//                                             EFFECTS: bare, the scene without any; NAME, that one
//                                             alone (and what it needs); -NAME, none, with a Def
//                                             full of NaN where it would be
//   tick_count --bytes                        of a scene on the bare first script, on the heap
//   tick_count --effects                      what NAME may be, a line each
//   tick_count --list                         the scripts' names, a line each
//   tick_count --kinds                        what KIND may be here, a line each
#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/support/effect_scenes.h"
#include "tests/support/tick_scripts.h"
#include "tests/support/vector_kinds.h"

namespace {

// The scene with those effects alone; false where there is none of that name.
bool choose_effects(onggi::SceneDef& def, std::string_view words) {
  def = onggi::bare(def);
  if (words == "bare") return true;
  const bool absent = words.starts_with('-');
  for (const onggi::EffectTrial& effect : onggi::effect_trials()) {
    if (effect.name != words.substr(absent ? 1 : 0)) continue;
    (absent ? effect.leave_out_full_of_nan : effect.add)(def);
    return true;
  }
  return false;
}

// All that is held; a sanitizer's heap is another, but it does not come here.
std::size_t bytes_held() {
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

int print_bytes() {
  const onggi::SceneDef def = onggi::bare(onggi::tick_scripts().front().scene(400, 360));
  const std::size_t before = bytes_held();
  const auto scene = onggi::Scene::create(def);
  if (!scene) return 1;
  std::printf("%zu\n", bytes_held() - before);
  return 0;
}

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
  if (word == "--bytes") return print_bytes();
  if (word == "--effects") {
    for (const EffectTrial& effect : effect_trials()) std::printf("%s\n", effect.name.c_str());
    return 0;
  }
  const auto kind = choose_vectors(argc > 4 ? argv[4] : "");
  if (argc < 4 || !kind) {
    std::fprintf(stderr,
                 "tick_count SCRIPT ROWS SECTORS [KIND [EFFECTS]], or --list, --kinds, --effects, "
                 "--bytes\n");
    return 1;
  }
  const TickScript& script = tick_script(word);
  SceneDef def = script.scene(std::atoi(argv[2]), std::atoi(argv[3]));
  if (argc > 5 && !choose_effects(def, argv[5])) {
    std::fprintf(stderr, "There is no effect \"%s\".\n", argv[5]);
    return 1;
  }
  auto scene = Scene::create(def, *kind);
  if (!scene) {
    std::fprintf(stderr, "%s: %s\n", scene.error().where.c_str(), scene.error().what.c_str());
    return 1;
  }
  for (int n = 0; n < kBefore; ++n) scene->step(script.hands(n), kTickSeconds);
  onggi_counted_ticks(*scene, script);
  std::printf("%016llx\n", static_cast<unsigned long long>(scene->state_hash()));
  return 0;
}
