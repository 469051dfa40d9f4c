#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/profile/up.h"
#include "kiosk/collection/archives/unpack.h"
#include "kiosk/collection/content/scan_folder.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/output.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/commands/up_option.h"
#include "kiosk/program/commands/vessel_json.h"

namespace onggi::commands {

namespace {

namespace fs = std::filesystem;
using files::Json;
constexpr std::size_t kMostScans = 12;

struct LookArguments {
  std::string file;
  files::Output json{files::Output::Kind::json, "-"};
};

/// What the page asks about, and what it can fill in by itself.
Json asked_about(const content::Vessel& vessel) {
  Json out = vessel_json(vessel);
  const Vec3 up = vessel.extracted.axis_direction;
  out["node"] = vessel.node;
  out["up_axis"] = extraction::axis_name(up);
  out["down_axis"] = extraction::axis_name(-up);
  out["up_is_sure"] = vessel.extracted.up_sure >= ExtractedProfile::kSureUp;
  out["size_is_sure"] =
      content::is_known(vessel.size_from) || vessel.size_from == content::SizeFrom::file;
  out["title"] = vessel.label("en").title;
  out["institution"] = vessel.given.institution;
  return out;
}

/// Unpacks an archive that lies in `folder` into a folder beside it, once.
Result<void> unpack_archives(const fs::path& folder) {
  std::vector<fs::path> archives;
  std::error_code gone;
  for (fs::directory_iterator it(folder, gone), end; !gone && it != end; it.increment(gone))
    if (archives::is_archive_ending(it->path())) archives.push_back(it->path());
  for (const fs::path& archive : archives) {
    const fs::path into = archive.string() + ".unpacked", part = archive.string() + ".part";
    if (fs::exists(into, gone)) continue;
    fs::remove_all(part, gone);  // of a look that was killed
    if (auto done = archives::unpack(archive, part); !done) return done;
    fs::rename(part, into, gone);
  }
  return {};
}

/// The vessels of a file, or of all scans in a folder.
struct Seen {
  std::vector<content::Vessel> vessels;
  std::vector<Problem> unusable;
};

/// A name that several objects of a file share leads to the first of them.
void leave_out_namesakes(Seen& seen) {
  std::map<std::pair<fs::path, std::string>, int> count;
  for (const content::Vessel& vessel : seen.vessels) ++count[{vessel.file, vessel.node}];
  std::erase_if(seen.vessels, [&](const content::Vessel& vessel) {
    return count[{vessel.file, vessel.node}] > 1 || vessel.node.find('\0') != std::string::npos;
  });
  for (const auto& [of, times] : count)
    if (times > 1)
      seen.unusable.push_back({of.first.string(),
                               std::to_string(times) + " objects are called \"" + of.second + "\".",
                               "Give each a name of its own, and export the scan again."});
}

Result<Seen> vessels_in(const fs::path& path) {
  Seen seen;
  std::vector<fs::path> scans{path};
  std::error_code gone;
  if (fs::is_directory(path, gone)) {
    if (auto done = unpack_archives(path); !done) return tl::unexpected(done.error());
    const content::FolderScans found = content::scans_in(path);
    scans.clear();
    for (const fs::path& scan : found.offered()) scans.push_back(path / scan);
    seen.unusable = found.unusable;
    if (scans.size() > kMostScans)
      return problem(path.string(), "There are more than 12 scans.", "Send fewer at once.");
  }
  for (const fs::path& scan : scans) {
    auto vessels = content::load_vessels(scan);
    if (!vessels)
      seen.unusable.push_back(vessels.error());
    else
      std::ranges::move(*vessels, std::back_inserter(seen.vessels));
  }
  leave_out_namesakes(seen);
  if (!seen.vessels.empty()) return seen;
  if (!seen.unusable.empty()) return tl::unexpected(seen.unusable.front());
  return problem(path.string(), "There is no scan in it.",
                 "Send a GLB, glTF, OBJ, PLY or STL file with all that belongs to it, or a zip.");
}

/// `remedy` for somebody at a page: there is no command line, and files are sent.
std::string for_a_page(std::string remedy) {
  const std::string_view option = "; --node NAME, or node in vessel.toml, reads one alone";
  if (const auto at = remedy.find(option); at != std::string::npos) remedy.erase(at, option.size());
  if (remedy.find("beside it") != std::string::npos)
    remedy = "Send all files of the scan together, or as a zip.";
  return remedy;
}

Result<int> look(const LookArguments& arguments) {
  const auto seen = vessels_in(arguments.file);
  Json out = Json::object({{"done", seen.has_value()}});
  if (seen) {
    Json list = Json::list(), notes = Json::list();
    for (const content::Vessel& vessel : seen->vessels) list.push_back(asked_about(vessel));
    for (const Problem& note : seen->unusable)
      notes.push_back(fs::path(note.where).filename().string() + ": " + note.what);
    out["vessels"] = list;
    out["notes"] = notes;
  } else {
    out["what"] = seen.error().what;
    out["remedy"] = for_a_page(seen.error().remedy);
  }
  if (auto put = arguments.json.write(out.text(-1) + "\n"); !put)
    return tl::unexpected(put.error());
  return seen ? 0 : 2;
}

}  // namespace

cli::Command look_command() {
  const auto a = std::make_shared<LookArguments>();
  return {.name = "look",
          .help = "Tell programs which vessels are in a scan, and what is in doubt about each",
          .examples = "Example: onggi vessel look scan.glb",
          .options = {{.name = "file",
                       .field = &a->file,
                       .help = "A scan, or a folder with scans; archives in it are unpacked there",
                       .required = true},
                      {"--json", &a->json, "Write it into this file [standard output]"}},
          .run = [a] { return look(*a); }};
}

}  // namespace onggi::commands
