#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "engine/base/result.h"

namespace onggi::files {

/// A place that a command was told to write to: --json, --csv, --plot, -o. What it never does:
/// - replace anything but a regular file: a device or a pipe is written to, a link is followed, and
///   a disk, a folder or a socket is refused;
/// - replace a file that this run has read (note_read()), or that is of another kind than is
///   written, unless it is forced; an empty file is of every kind;
/// - make a folder.
/// A regular file is replaced durably (write_durably()).
class Output {
 public:
  enum class Kind {
    json,
    csv,
    picture,  ///< An SVG where the name ends in ".svg", else a PNG.
    glb,
    wav,
    archive,  ///< What gzip has packed.
  };

  explicit Output(Kind kind, std::string where = "") : kind_(kind), where_(std::move(where)) {}

  /// As typed: a file's name; "-" for standard output; empty for nowhere.
  std::string& where() { return where_; }
  const std::string& where() const { return where_; }
  bool wanted() const { return !where_.empty(); }
  /// What is written goes where std::cout goes, which is then no place for a summary: "-", or the
  /// very file or pipe that standard output is.
  bool to_stdout() const;
  /// A file of another kind may be replaced. One that was read may not.
  void force() { forced_ = true; }

  /// Whether it could be written now, before the work of minutes begins. Problem: 2 for what the
  /// command line should not have named, 1 for what the disk does not allow. Writes nothing.
  Result<void> check() const;

  /// Writes all of `bytes`; where that is nowhere, nothing. Problem as check(), and 1 where the
  /// disk or the reader does not take them. Blocks; any thread.
  Result<void> write(std::span<const std::byte> bytes) const;
  Result<void> write(const std::string& text) const;

  /// Whether both would be one file, or both standard output: devices may be written to twice.
  bool clashes_with(const Output& other) const;

 private:
  Kind kind_;
  std::string where_;
  bool forced_ = false;
};

}  // namespace onggi::files
