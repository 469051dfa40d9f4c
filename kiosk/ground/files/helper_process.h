#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::files {

/// A program that does one piece of work for the kiosk.
struct Helper {
  std::string program{};  ///< A path, or a name to be found in PATH.
  std::vector<std::string> arguments{};
  std::string head{};                    ///< Sent to its standard input first,
  std::span<const std::uint8_t> body{};  ///< and this after it.
  /// The helper is killed after this many seconds of processor time, or after as many seconds
  /// without progress. On a busy machine it may take longer in total.
  double timeout_s = 20.0;
  std::size_t most_bytes = 1u << 20;  ///< Largest output allowed.
  const char* answer = "answer";      ///< What its output is called in a Problem: "picture".
  int also_good = 0;                  ///< An exit status with which its output is whole too.
};

/// Starts the helper, sends head and body, collects its standard output until it ends, and always
/// waits for it. Blocks, so do not call it on the main thread of an open exhibit. Problem (exit 1):
/// it cannot be started, it works or hangs longer than `timeout_s` (it is then killed), its exit
/// status is not 0 (the Problem quotes the end of its standard error), or it writes more than
/// `most_bytes`.
Result<std::vector<std::byte>> run_helper(const Helper& helper);

}  // namespace onggi::files
