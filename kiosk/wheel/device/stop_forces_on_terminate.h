#pragma once

namespace onggi::device {

/// True when the program is about to end. Every link asks before it lets a device push, so that
/// devices are switched off while threads can still write to them.
bool program_ends() noexcept;

/// From now on each link sends only "off", at its next turn. Any thread; does not wait.
void stop_all_forces() noexcept;

/// main calls this once: an uncaught exception then ends every force before it ends the program. It
/// waits kLastWord seconds for the links.
void stop_forces_on_terminate() noexcept;
inline constexpr double kLastWord = 0.02;

}  // namespace onggi::device
