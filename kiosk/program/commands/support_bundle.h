#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::commands {

/// One text of a support bundle, and its name there.
struct BundlePart {
  std::string name, text;
};

/// The places that a support bundle reads. All but `config` default to a kiosk's own if empty.
struct BundleSources {
  std::filesystem::path config;                    ///< exhibit.toml
  std::filesystem::path state = "/var/lib/onggi";  ///< How the last runs ended
  std::filesystem::path health = "/run/onggi/onggi.prom";
};

/// The data that a remote helper needs: version, machine, the exhibit's configuration, the output
/// of onggi check, health, crashes, the last 5000 lines of the log, disk, and counts, suppressed as
/// in onggi stats. It holds nothing about visitors: no picture, pot or replay, no keepsake's name,
/// and no log line that tells when one was made. If something cannot be read, the reason takes its
/// place. Calls `step` before each step. Blocks for seconds; starts journalctl.
std::vector<BundlePart> gather_bundle(const BundleSources& sources,
                                      const std::function<void(const std::string&)>& step);

/// Removes visitors' traces from `text`: lines about kept keepsakes are removed, and keepsake names
/// ("2026-05-04_141503_moon_jar") become "KEEPSAKE".
std::string without_visitors(const std::string& text);

/// The parts as a .tar.gz with a folder `onggi-report`; tar and gzip are on every Debian. Problem
/// (exit 1) if they are missing.
Result<std::vector<std::byte>> pack_bundle(const std::vector<BundlePart>& parts);

}  // namespace onggi::commands
