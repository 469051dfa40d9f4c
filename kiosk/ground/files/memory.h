#pragma once

namespace onggi::files {

/// Keeps freed memory from staying with the process for months: blocks of 256 KiB and more
/// (pictures, postcards, clay) are mapped one by one and go back to the system when freed, and at
/// most two arenas hold the rest. Call first in main. glibc only; elsewhere it does nothing.
///
/// Why: glibc raises its mapping threshold to the largest block ever freed (32 MiB), after which a
/// postcard of 12 MB is carved out of the arena of whichever worker made it. Measured in a soak: 50
/// MiB more a visit, none of it in use; with this, none.
///
/// Up to 32 MiB free at the heap's end stay, though: a software rasterizer frees and takes its few
/// megabytes for every frame, and with glibc's 128 KiB of patience each of them was given back to
/// the system and faulted in again, half of all that the drawing thread did (perf, llvmpipe, 1280 x
/// 720).
void keep_heap_small() noexcept;

/// Keeps in memory what was once in memory, of now and later, so that the 1 kHz loop waits for no
/// disk. Pages that nobody touched are not fetched for it: a driver's reserves would fill a small
/// machine. 0, or errno: EPERM where the limit of locked memory is not infinite. Any thread.
int lock_memory() noexcept;

/// Gives the holes in the heap back to the system: between two visitors, when nobody feels what it
/// takes (some milliseconds). Holes among small blocks that stay are never given back by free():
/// without this they grow for some forty visits, by 70 MiB in a soak. A process whose memory is
/// locked keeps its holes too, so it is unlocked meanwhile, and locked again. Any thread; waits for
/// those that allocate. glibc only; elsewhere it does nothing.
void give_back_memory() noexcept;

}  // namespace onggi::files
