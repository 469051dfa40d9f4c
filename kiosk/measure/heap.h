#pragma once

namespace onggi::measure {

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
void keep_heap_small();

}  // namespace onggi::measure
