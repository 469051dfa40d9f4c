#pragma once

#include <cstddef>

namespace onggi::files {

/// Seconds on CLOCK_MONOTONIC: never goes back, whatever happens to the wall clock.
double monotonic_seconds();

/// Seconds of processor time that the calling thread has used.
double thread_seconds();

/// Seconds since this process began to exist (exec), from /proc; 10 ms fine. 0 when that cannot be
/// read.
double since_exec_seconds();

/// Resident memory of this process now, bytes; 0 when that cannot be read.
long resident_bytes();

/// What this process asked for and has not freed, bytes: resident memory is that, holes between,
/// and files. 0 where malloc does not tell (glibc's does). Waits for who allocates.
std::size_t bytes_in_use();

}  // namespace onggi::files
