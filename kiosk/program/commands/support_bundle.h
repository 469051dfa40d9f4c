#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::commands {

/// One text of a support bundle, by its name in it.
struct BundlePart {
  std::string name, text;
};

/// Where a kiosk keeps what a support bundle tells. All but `config` are a kiosk's own where empty.
struct BundleSources {
  std::filesystem::path config;                    ///< exhibit.toml
  std::filesystem::path state = "/var/lib/onggi";  ///< How the last runs ended.
  std::filesystem::path health = "/run/onggi/onggi.prom";
};

/// What somebody far away needs in order to help: version, machine, the exhibit's configuration,
/// what onggi check says, health, crashes, the last 5000 lines of the log, disk and counts, of
/// which small ones are left out as in onggi stats. Nothing of a visitor: no picture, pot or
/// replay, no name of a keepsake and no line of the log that tells when one was made. What cannot
/// be read is told in its place. `step` hears what is being done, before it is. Blocks for seconds;
/// starts journalctl.
std::vector<BundlePart> gather_bundle(const BundleSources& sources,
                                      const std::function<void(const std::string&)>& step);

/// `text` without what tells of a visitor: lines that say what was kept are left out, and names of
/// keepsakes ("2026-05-04_141503_moon_jar") give way to "KEEPSAKE".
std::string without_visitors(const std::string& text);

/// The parts as a .tar.gz, in a folder `onggi-report`; tar and gzip are on every Debian. Problem
/// (exit 1) where they are not.
Result<std::vector<std::byte>> pack_bundle(const std::vector<BundlePart>& parts);

}  // namespace onggi::commands
