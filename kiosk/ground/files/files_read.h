#pragma once

#include <sys/stat.h>

namespace onggi::files {

/// Remembers by device and inode which files this run has read, so that a link or another name is
/// recognised. read_file() and read_beneath() record them; Output asks. Any thread.
void note_read(const struct stat& file);
bool was_read(const struct stat& file);

}  // namespace onggi::files
