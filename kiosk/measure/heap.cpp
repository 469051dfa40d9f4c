#include "kiosk/measure/heap.h"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace onggi::measure {

void keep_heap_small() {
#if defined(M_MMAP_THRESHOLD) && defined(M_ARENA_MAX)
  mallopt(M_MMAP_THRESHOLD, 256 * 1024);
  mallopt(M_ARENA_MAX, 2);
#endif
}

}  // namespace onggi::measure
