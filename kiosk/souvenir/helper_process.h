#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::souvenir {

struct HelperOutput {
  std::vector<std::byte> out;  ///< Everything it wrote to standard output.
};

/// Starts `program`, gives it `head` and then `body` on standard input, and takes what it writes
/// until it ends. It inherits nothing but those three descriptors, no blocked or ignored signal,
/// and is always waited for. Changes no signal of this process. Blocks; not for the main thread.
/// Problem (exit 1): cannot be started, does not end within `timeout_s` (killed then), ends with
/// another status than 0 (its last words on standard error are in the Problem), or writes more than
/// `most_bytes`.
Result<HelperOutput> run_helper(const std::filesystem::path& program, const std::string& head,
                                std::span<const std::uint8_t> body, double timeout_s,
                                std::size_t most_bytes);

}  // namespace onggi::souvenir
