#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "engine/base/result.h"

namespace onggi::files {

/// The target of --json, --csv, --plot or -o. A regular file is replaced durably (write_durably()),
/// a device or a pipe is written to, and a link is followed. It never
/// - replaces a disk, a folder or a socket;
/// - replaces a file that this run has read (note_read()), or, unless forced, a file of another
/// kind; an empty file is of every kind;
/// - gives a file a name that ends as another kind does, unless forced;
/// - creates a folder.
class Output {
 public:
  enum class Kind {
    json,
    csv,
    picture,  ///< An SVG if the name ends in ".svg", else a PNG.
    png,
    stl,  ///< Binary, for a 3D printer.
    glb,
    wav,
    archive,  ///< Anything packed by gzip.
  };

  explicit Output(Kind kind, std::string where = "") : kind_(kind), where_(std::move(where)) {}

  /// As typed: a file name; "-" for standard output; empty for no output.
  std::string& where() { return where_; }
  const std::string& where() const { return where_; }
  bool wanted() const { return !where_.empty(); }
  /// True if the output goes to standard output, by "-" or because it is the same file or pipe. A
  /// summary must then not go there.
  bool to_stdout() const;
  /// Allows replacing a file of another kind, but not a file that was read.
  void force() { forced_ = true; }

  /// Checks, before minutes of work begin, that it could be written now. Problem: exit 2 for a
  /// wrong name on the command line, 1 for what the disk does not allow. Writes nothing.
  Result<void> check() const;

  /// Writes all of `bytes`; nothing if there is no output. Problems as in check(), and exit 1 if
  /// the disk or the reader does not take the bytes. Blocks; any thread.
  Result<void> write(std::span<const std::byte> bytes) const;
  Result<void> write(const std::string& text) const;

  /// True if both are the same file, or both standard output. Two outputs may share a device.
  bool clashes_with(const Output& other) const;

 private:
  Kind kind_;
  std::string where_;
  bool forced_ = false;
};

}  // namespace onggi::files
