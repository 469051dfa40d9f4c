#pragma once

#include <sys/stat.h>

namespace onggi::files {

/// Which files this run of the program has read, by device and inode, so that a link or another
/// name is known too. read_file() and read_beneath() note them; Output asks. Any thread.
void note_read(const struct stat& file);
bool was_read(const struct stat& file);

}  // namespace onggi::files
