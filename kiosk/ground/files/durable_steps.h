#pragma once

#include <array>
#include <string_view>

namespace onggi::files {

/// The steps of write_durably() that a power cut can fall between, in order. After "synced" all new
/// bytes are on the disk; from "renamed" on the file has them.
inline constexpr std::array<std::string_view, 6> kDurableSteps{
    "opened", "half written", "written", "synced", "renamed", "folder synced"};

/// Called after each step of a write that must survive a power cut. A test sets one to end its
/// process there; a program sets none. Not to be set while another thread writes.
using StepWatcher = void (*)(std::string_view step);
void watch_steps(StepWatcher watcher);

/// Tells the watcher, if there is one, that a step is done.
void step_done(std::string_view step);

}  // namespace onggi::files
