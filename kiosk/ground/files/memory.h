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
/// Up to 32 MiB of free memory at the heap's end stay with the process. A software rasterizer frees
/// and takes a few megabytes for every frame. With glibc's default of 128 KiB each of them went
/// back to the system and was faulted in again, which was half of the drawing thread's work (perf,
/// llvmpipe, 1280 x 720).
void keep_heap_small() noexcept;

/// Locks memory that is or will be used, so that the 1 kHz loop never waits for the disk. Untouched
/// pages are not fetched, because a driver's reserves would fill a small machine. Returns 0 or
/// errno: EPERM if the limit of locked memory is not infinite. Any thread.
int lock_memory() noexcept;

/// Returns free heap memory to the system. Call it between two visitors, when the few milliseconds
/// that it takes are not felt. free() never returns gaps among small blocks that stay: without this
/// call they grew for some forty visits, by 70 MiB in a soak. Locked memory keeps its gaps too, so
/// memory is unlocked meanwhile and then locked again. Any thread; waits for threads that allocate.
/// glibc only; elsewhere it does nothing.
void give_back_memory() noexcept;

}  // namespace onggi::files
