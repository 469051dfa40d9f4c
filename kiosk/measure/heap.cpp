#include "kiosk/measure/heap.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace onggi::measure {
namespace {

constexpr int kSpare = 32 * 1024 * 1024, kPad = 4 * 1024 * 1024;

}  // namespace

void keep_heap_small() {
#if defined(M_MMAP_THRESHOLD) && defined(M_ARENA_MAX)
  mallopt(M_MMAP_THRESHOLD, 256 * 1024);
  mallopt(M_ARENA_MAX, 2);
  mallopt(M_TRIM_THRESHOLD, kSpare);
  mallopt(M_TOP_PAD, kPad);
#endif
}

}  // namespace onggi::measure
