#pragma once

namespace onggi::device {

/// What every link asks before it lets a device push: the program is about to end, and its devices
/// are to be told so while there are still threads that may write to them.
bool program_ends() noexcept;

/// From now on links say off, in their next turn, and nothing else. Any thread; does not wait.
void end_all_forces() noexcept;

/// Called once, by main: an exception that nobody catches ends every force before it ends the
/// program. It waits for the links' turns, kLastWord seconds.
void end_forces_on_terminate() noexcept;
inline constexpr double kLastWord = 0.02;

}  // namespace onggi::device
