#include "kiosk/program/commands/scan_archive.h"

#include <algorithm>
#include <utility>

#include "kiosk/collection/archives/unpack.h"
#include "kiosk/collection/content/scan_folder.h"

namespace onggi::commands {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNamed = 12;

std::string list_of(const std::vector<fs::path>& scans) {
  std::string list;
  for (std::size_t n = 0; n < std::min(scans.size(), kMostNamed); ++n)
    list += (n == 0 ? "" : ", ") + scans[n].generic_string();
  if (scans.size() > kMostNamed)
    list += " and " + std::to_string(scans.size() - kMostNamed) + " more";
  return list;
}

void replace_all(std::string& text, const std::string& old, const std::string& now) {
  for (auto at = text.find(old); at != std::string::npos; at = text.find(old, at + now.size()))
    text.replace(at, old.size(), now);
}

}  // namespace

Result<ScanArchive> ScanArchive::open(const fs::path& file, const std::string& name) {
  auto folder = files::PassingFolder::make("import");
  if (!folder) return tl::unexpected(folder.error());
  ScanArchive archive(file, std::move(*folder));
  if (auto good = archives::unpack(file, archive.folder_.path() / "scan"); !good)
    return tl::unexpected(archive.as_named(good.error()));
  if (auto good = archive.choose(name); !good) return tl::unexpected(good.error());
  return archive;
}

Result<void> ScanArchive::choose(const std::string& name) {
  const fs::path root = folder_.path() / "scan";
  const content::FolderScans found = content::scans_in(root);
  for (const Problem& told : found.unusable) notes_.push_back(as_named(told));
  std::vector<fs::path> all = found.documents;
  all.insert(all.end(), found.meshes.begin(), found.meshes.end());
  if (all.empty() && !notes_.empty()) return tl::unexpected(notes_.front());
  if (all.empty())
    return problem(
        file_.string(), "There is no scan in this archive.",
        "Put a GLB, glTF, OBJ, PLY or STL file into it, with the files that belong to it.");
  if (name.empty() && found.offered().size() > 1)
    return problem(file_.string(),
                   "There are several scans in this archive: " + list_of(found.offered()) + '.',
                   "Name one: --scan '" + found.offered().front().generic_string() + "'.");
  const auto named = std::ranges::find(all, fs::path(name));
  if (!name.empty() && named == all.end())
    return problem("--scan " + name, "There is no scan of this name in the archive.",
                   "It has: " + list_of(all) + '.');
  scan_ = root / (name.empty() ? found.offered().front() : *named);
  return {};
}

Problem ScanArchive::as_named(Problem told) const {
  const std::string root = (folder_.path() / "scan").string();
  for (std::string* text : {&told.where, &told.what, &told.remedy}) {
    replace_all(*text, root + '/', file_.string() + ", ");
    replace_all(*text, root, file_.string());
  }
  return told;
}

}  // namespace onggi::commands
