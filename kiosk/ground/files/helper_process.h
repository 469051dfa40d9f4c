#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::files {

/// A program that is to do a piece of work for us.
struct Helper {
  std::string program{};  ///< A path, or a name to be found in PATH.
  std::vector<std::string> arguments{};
  std::string head{};                    ///< What it is given on standard input,
  std::span<const std::uint8_t> body{};  ///< and what after that.
  /// Seconds of work until it is killed; and as many in which it gets no work done at all. On a
  /// machine that is busy otherwise it may take as long as it needs.
  double timeout_s = 20.0;
  std::size_t most_bytes = 1u << 20;  ///< That it may write.
  const char* answer = "answer";      ///< What it writes is one: "picture".
};

/// Starts it, gives it head and body, and takes what it writes to standard output until it ends; it
/// is always waited for. Blocks; not for the main thread of an open exhibit. Problem (exit 1):
/// cannot be started, works for over `timeout_s` or stands still so long (killed then), ends with
/// another status than 0 (its last words on standard error are in the Problem), or writes more than
/// `most_bytes`.
Result<std::vector<std::byte>> run_helper(const Helper& helper);

}  // namespace onggi::files
