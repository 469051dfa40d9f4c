#include <filesystem>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/base/plain_text.h"
#include "kiosk/collection/archives/unpack.h"
#include "kiosk/collection/content/coloring.h"
#include "kiosk/collection/content/glb.h"
#include "kiosk/collection/content/glb_packer.h"
#include "kiosk/collection/content/gltf_parts.h"
#include "kiosk/collection/content/mesh_file.h"
#include "kiosk/collection/content/pack.h"
#include "kiosk/collection/content/pack_writer.h"
#include "kiosk/collection/content/vessel_file.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/files/output.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/shared_folder.h"
#include "kiosk/program/commands/commands.h"
#include "kiosk/program/commands/scan_archive.h"
#include "kiosk/program/commands/up_option.h"

namespace fs = std::filesystem;

namespace onggi::commands {

namespace {

using files::Json;
constexpr double kLeastHeight_mm = 4.0, kMostHeight_mm = 2000.0;  // as the shelf takes

struct ImportArguments {
  std::string file, id, scan, node, up, shelf;
  double height_mm = 0.0;
  files::Output json{files::Output::Kind::json};
};

/// Where the vessel goes, and the languages that its label needs.
struct Place {
  fs::path shelf;
  std::vector<std::string> languages;
};

/// `--shelf`, else the shelf of the exhibit in the current folder or above it.
Result<Place> place_of(const std::string& shelf) {
  const fs::path exhibit = files::site_exhibit(shelf.empty() ? "." : shelf);
  Place place{shelf, {}};
  if (!exhibit.empty()) {
    const settings::Exhibit read = settings::read_exhibit(exhibit).exhibit;
    place.languages = read.languages;
    // Named as somebody here would name it.
    std::error_code ignored;
    if (shelf.empty()) place.shelf = fs::proximate(read.shelf, ignored);
  }
  if (place.shelf.empty())
    return problem("--shelf", "There is no exhibit in this folder or above it.",
                   "Change into the exhibit's folder first (on a kiosk: cd /srv/onggi), or name a "
                   "shelf: --shelf FOLDER.");
  std::error_code ignored;
  if (!fs::is_directory(place.shelf, ignored))
    return problem(
        "--shelf " + place.shelf.string(), "The folder does not exist.",
        "Create it first: mkdir -p '" + place.shelf.string() + "'. Or name another shelf.");
  return place;
}

Result<void> check_id(const std::string& id) {
  bool good = !id.empty() && id.size() <= 80;
  for (const char c : id)
    good = good && ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-');
  if (good) return {};
  return problem("--id " + id.substr(0, 80),
                 "an id is a folder name with only a to z, 0 to 9, _ and -.",
                 "Write one such as moon_jar.");
}

/// The vessel's file: unchanged if it is a complete GLB; a complete glTF with all its files; else
/// only its surface with its colours, because a pack holds one file.
Result<std::vector<std::byte>> glb_of(const content::Vessel& vessel, bool whole) {
  const settings::ReaderLimits limits;
  if (whole) {
    const auto bytes =
        content::read_vessel_file(vessel.file, static_cast<std::size_t>(limits.file_mb) << 20);
    if (!bytes) return tl::unexpected(bytes.error());
    const bool is_glb = bytes->size() > 4 && (*bytes)[0] == 'g' && (*bytes)[1] == 'l' &&
                        (*bytes)[2] == 'T' && (*bytes)[3] == 'F';
    if (is_glb) {
      const auto span = std::as_bytes(std::span(*bytes));
      return std::vector<std::byte>(span.begin(), span.end());
    }
  }
  if (whole && content::format_unit(vessel.file) > 0.0)
    return content::pack_glb(vessel.file, limits);
  const auto model = content::read_mesh_file(vessel.file, limits);
  if (!model) return tl::unexpected(model.error());
  content::NamedPart named;
  if (!vessel.node.empty()) named = content::find_part(*model, vessel.node);
  std::string rights = vessel.credit;
  if (!vessel.licence.empty()) rights += (rights.empty() ? "" : ". ") + vessel.licence;
  const bool all = named.part == nullptr;
  const content::Coloring coloring =
      all ? model->coloring : content::coloring_of(*model, *named.part, named.reach);
  content::GlbMaterial material;
  if (model->colored) material.color = model->base_color;
  if (!coloring.empty()) material.color = {1, 1, 1};
  return content::write_glb(all ? model->mesh : content::mesh_of(*model, *named.part, named.reach),
                            vessel.label("en").title, rights, material, content::baked(coloring));
}

/// Where the vessel lies, what it lacks, and what to do next.
void tell(const fs::path& folder, std::size_t bytes, const std::vector<std::string>& languages) {
  const std::string name = terminal::plain(folder.string());
  const content::PackRead pack = content::read_pack(folder / "vessel.toml", languages);
  std::cout << name << "/vessel.glb   the shape, " << bytes / 1024 << " kB\n"
            << name << "/vessel.toml  what visitors read about it\n"
            << "\nVisitors do not see it yet. To fill in:\n";
  for (const auto* found : {&pack.problems, &pack.advice})
    for (const Problem& gap : *found) std::cout << "  - " << terminal::plain(gap.what) << '\n';
  std::cout << "\n1. Open " << name
            << "/vessel.toml in an editor. Complete it, and remove each #.\n"
            << "2. onggi check " << name << "           tells what is still missing\n"
            << "3. onggi vessel inspect " << name << "  tells what was read from the shape\n"
            << "4. Remove the line unfinished = true. The vessel then stands on the shelf.\n";
}

Result<void> check_height(double height_mm) {
  if (height_mm == 0.0 || (height_mm >= kLeastHeight_mm && height_mm <= kMostHeight_mm)) return {};
  return problem("--height", "a vessel is 4 to 2000 mm tall.", "Write its height in millimetres.");
}

/// A vessel's folder on the shelf, whose label is to be written.
struct Imported {
  fs::path folder;
  std::size_t bytes = 0;
  std::vector<std::string> languages, notes;
};

/// Makes the folder of these files. It stands there whole or not at all: a shape without its label
/// would be shown to visitors.
Result<void> put_folder(const fs::path& folder, const std::vector<std::byte>& glb,
                        const std::string& toml) {
  const fs::path made = folder.parent_path() / ("." + folder.filename().string() + ".new");
  std::error_code failed;
  fs::remove_all(made, failed);  // of an import that was killed
  auto done = files::make_folder(made);
  if (done) done = files::write_durably(made / "vessel.glb", glb);
  if (done) done = files::write_durably(made / "vessel.toml", std::as_bytes(std::span(toml)));
  if (done) {
    files::share_as_above(made);
    fs::rename(made, folder, failed);
    if (failed)
      done = problem(folder.string(), "the folder cannot be put there: " + failed.message() + ".",
                     "Check who may write in the shelf, and try again.", 1);
  }
  std::error_code gone;
  if (!done) fs::remove_all(made, gone);
  return done;
}

/// Makes the vessel's folder from the file `scan`.
Result<Imported> make_folder_of(const fs::path& scan, const fs::path& folder,
                                const content::LoadOptions& options, double height_mm,
                                const Place& place) {
  auto vessel = content::load_vessel(scan, options);
  if (!vessel) return tl::unexpected(vessel.error());
  if (height_mm > 0.0) vessel->true_height = height_mm / 1000.0;
  const auto glb = glb_of(*vessel, options.node.empty());
  if (!glb) return tl::unexpected(glb.error());

  if (auto good = put_folder(folder, *glb, content::pack_toml(*vessel)); !good)
    return tl::unexpected(good.error());
  return Imported{folder, glb->size(), place.languages, vessel->extracted.warnings};
}

/// The same from the scan in an archive.
Result<Imported> make_folder_of_archive(const ImportArguments& arguments, const fs::path& folder,
                                        const content::LoadOptions& options, const Place& place) {
  const auto archive = ScanArchive::open(arguments.file, arguments.scan);
  if (!archive) return tl::unexpected(archive.error());
  auto made = make_folder_of(archive->scan(), folder, options, arguments.height_mm, place);
  if (!made) return tl::unexpected(archive->as_named(made.error()));
  for (const Problem& note : archive->notes()) made->notes.push_back(note.where + ": " + note.what);
  return made;
}

Result<Imported> import_vessel(const ImportArguments& arguments) {
  if (auto good = check_id(arguments.id); !good) return tl::unexpected(good.error());
  if (auto good = check_height(arguments.height_mm); !good) return tl::unexpected(good.error());
  const auto place = place_of(arguments.shelf);
  if (!place) return tl::unexpected(place.error());
  const fs::path folder = place->shelf / arguments.id;
  std::error_code ignored;
  if (fs::exists(folder, ignored))
    return problem(folder.string(), "the folder exists, so it is not overwritten.",
                   "Choose another --id, or move the folder away.");
  content::LoadOptions options;
  options.node = arguments.node;
  if (auto good = take_up(arguments.up, options); !good) return tl::unexpected(good.error());
  if (archives::is_archive_ending(arguments.file))
    return make_folder_of_archive(arguments, folder, options, *place);
  if (!arguments.scan.empty())
    return problem("--scan " + arguments.scan, "only a zip archive has scans to choose from.",
                   "Leave --scan out.");
  return make_folder_of(arguments.file, folder, options, arguments.height_mm, *place);
}

/// For programs, such as the staff's page.
Result<int> answer(const files::Output& json, const Result<Imported>& done) {
  Json out = Json::object({{"done", done.has_value()}});
  if (!done) {
    out["what"] = done.error().what;
    out["remedy"] = done.error().remedy;
  }
  if (auto put = json.write(out.text(-1) + "\n"); !put) return tl::unexpected(put.error());
  return done ? 0 : 2;
}

Result<int> import(const ImportArguments& arguments) {
  const auto done = import_vessel(arguments);
  if (arguments.json.wanted()) return answer(arguments.json, done);
  if (!done) return tl::unexpected(done.error());
  tell(done->folder, done->bytes, done->languages);
  for (const std::string& note : done->notes)
    std::cout << "  note: " << terminal::plain(note) << '\n';
  return 0;
}

}  // namespace

cli::Command import_command() {
  const auto a = std::make_shared<ImportArguments>();
  return {
      .name = "import",
      .help = "Make a vessel's folder from a scan, which you then complete",
      .examples =
          "Example: onggi vessel import scan.glb --id moon_jar\n"
          "Example: onggi vessel import jar.zip --id moon_jar --scan jar/scan.obj\n"
          "It goes onto the exhibit's shelf; visitors see it when you have completed it.\n"
          "Copyright, licence and credit are taken from the file if it names them.",
      .options =
          {{.name = "file",
            .field = &a->file,
            .help = "A GLB, glTF, OBJ, PLY or STL file, a IIIF manifest or "
                    "Smithsonian document beside one, or a zip archive of them",
            .required = true},
           {.name = "--id",
            .field = &a->id,
            .help = "The folder's name: a to z, 0 to 9, _ and -",
            .required = true},
           {"--scan", &a->scan, "The scan in an archive that has several [the only one]"},
           {"--shelf", &a->shelf, "The shelf to put it on [the exhibit's]"},
           {"--node", &a->node, "The node that is the vessel, by name or number [all of the file]"},
           up_option(a->up),
           {"--height", &a->height_mm, "The real vessel's height in mm [as the file has it]"},
           {"--json", &a->json, "Tell what was done as JSON, for programs; - : standard output"}},
      .run = [a] { return import(*a); }};
}

}  // namespace onggi::commands
