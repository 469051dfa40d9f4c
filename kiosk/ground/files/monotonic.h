#pragma once

#include <cstddef>
#include <cstdint>

namespace onggi::files {

/// Seconds on CLOCK_MONOTONIC: it never goes back, whatever happens to the wall clock.
double monotonic_seconds();
/// The same in nanoseconds.
std::int64_t monotonic_ns() noexcept;

/// Seconds of processor time that the calling thread has used.
double thread_seconds();

/// Seconds since this process started (exec), from /proc, in steps of 10 ms. 0 if that cannot be
/// read.
double since_exec_seconds();

/// Resident memory of this process now, bytes; 0 when that cannot be read.
long resident_bytes();

/// Bytes that this process has allocated and not freed. Resident memory also holds gaps and files.
/// 0 if malloc cannot tell (glibc's can). Waits for threads that allocate.
std::size_t bytes_in_use();

}  // namespace onggi::files
