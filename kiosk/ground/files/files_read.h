#pragma once

#include <sys/stat.h>

namespace onggi::files {

/// Remembers by device and inode which files this run has read, so that a link or another name is
/// recognised. read_file() and read_beneath() record them; Output asks. Any thread.
void note_read(const struct stat& file);
bool was_read(const struct stat& file);
/// False: nothing more is noted, and what was is forgotten. For programs that run for months, read
/// a file for every visitor and write no Output. True at the start.
void note_reads(bool on);

}  // namespace onggi::files
