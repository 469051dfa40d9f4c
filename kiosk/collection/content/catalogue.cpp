#include "kiosk/collection/content/catalogue.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

#include "engine/profile/measures.h"
#include "kiosk/collection/content/drawing.h"
#include "kiosk/collection/content/mesh_file.h"
#include "kiosk/collection/content/pack.h"
#include "kiosk/collection/content/scan_document.h"
#include "kiosk/collection/decoration/decoration.h"

namespace onggi::content {

namespace {

namespace fs = std::filesystem;

/// A pack or a loose file, and its name on the shelf.
struct Entry {
  std::string id;
  fs::path path;
};

bool is_mesh(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  std::error_code ignored;
  return is_mesh_ending(ending) && fs::is_regular_file(file, ignored);
}

/// A folder's vessels without a vessel.toml: documents, and scans that no document of theirs names.
std::vector<fs::path> loose_of(const std::vector<fs::path>& files) {
  std::vector<fs::path> out, named;
  for (const fs::path& file : files) {
    if (!is_scan_document(file)) continue;
    out.push_back(file);
    if (const auto document = read_scan_document(file, {})) named.push_back(document->model);
  }
  for (const fs::path& file : files)
    if (is_mesh(file) && std::find(named.begin(), named.end(), file) == named.end())
      out.push_back(file);
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<fs::path> listed(const fs::path& folder, std::error_code& error) {
  std::vector<fs::path> out;
  for (auto at = fs::directory_iterator(folder, error); !error && at != fs::directory_iterator();
       at.increment(error))
    if (at->path().filename().string()[0] != '.') out.push_back(at->path());
  std::sort(out.begin(), out.end());
  return out;
}

/// A folder with a vessel.toml is a pack; a mesh beside it belongs to it.
std::vector<Entry> entries_of(const fs::path& shelf, std::error_code& error) {
  std::vector<Entry> out;
  const std::vector<fs::path> all = listed(shelf, error);
  for (const fs::path& path : loose_of(all)) out.push_back({path.stem().string(), path});
  for (const fs::path& path : all) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored)) continue;
    if (fs::exists(path / "vessel.toml", ignored)) {
      out.push_back({path.filename().string(), path});
      continue;
    }
    std::vector<Entry> loose;
    for (const fs::path& file : loose_of(listed(path, ignored)))
      loose.push_back({path.filename().string() + "_" + file.stem().string(), file});
    if (loose.size() == 1) loose[0].id = path.filename().string();
    out.insert(out.end(), loose.begin(), loose.end());
  }
  // a.glb beside a.gltf or a folder a: each keeps its own name.
  std::stable_sort(out.begin(), out.end(),
                   [](const Entry& a, const Entry& b) { return a.id < b.id; });
  for (std::size_t i = 1; i < out.size(); ++i)
    if (out[i].id == out[i - 1].id) out[i].id += "_" + std::to_string(i);
  return out;
}

bool has(const std::vector<std::string>& ids, const std::string& id) {
  return std::ranges::find(ids, id) != ids.end();
}

/// Moves the things named in `order` to the front. `is(thing, id)`: the thing is meant.
template <class Thing, class Is>
void put_first(std::vector<Thing>& things, const std::vector<std::string>& order, Is is) {
  auto front = things.begin();
  for (const std::string& id : order) {
    const auto named =
        std::find_if(front, things.end(), [&](const Thing& thing) { return is(thing, id); });
    if (named == things.end()) continue;
    std::rotate(front, named, named + 1);
    ++front;
  }
}

/// The entries that visitors see, in their order. Notes those that are hidden.
std::vector<Entry> arranged(std::vector<Entry> entries, const Arrangement& arrangement,
                            std::vector<std::string>* hidden = nullptr) {
  std::vector<std::string> ids;
  for (const Entry& entry : entries) ids.push_back(entry.id);
  // A file of several vessels stands where the first of them is named: "set" for "set_cup".
  put_first(entries, arrangement.order, [&ids](const Entry& entry, const std::string& id) {
    return entry.id == id || (!has(ids, id) && id.starts_with(entry.id + "_"));
  });
  std::erase_if(entries, [&](const Entry& entry) {
    const bool away = has(arrangement.hidden, entry.id);
    if (away && hidden != nullptr) hidden->push_back(entry.id);
    return away;
  });
  return entries;
}

/// The same for the vessels of one file.
void arrange(std::vector<Vessel>& vessels, const Arrangement& arrangement,
             std::vector<std::string>* hidden = nullptr) {
  put_first(vessels, arrangement.order,
            [](const Vessel& vessel, const std::string& id) { return vessel.id == id; });
  std::erase_if(vessels, [&](const Vessel& vessel) {
    const bool away = has(arrangement.hidden, vessel.id);
    if (away && hidden != nullptr) hidden->push_back(vessel.id);
    return away;
  });
}

/// Folders of a shelf that contain no vessel.
std::vector<fs::path> empty_folders(const fs::path& shelf, const std::vector<Entry>& entries) {
  std::vector<fs::path> out;
  std::error_code ignored;
  if (fs::exists(shelf / "vessel.toml", ignored)) return out;
  for (const fs::path& path : listed(shelf, ignored))
    if (fs::is_directory(path, ignored) &&
        std::none_of(entries.begin(), entries.end(), [&path](const Entry& entry) {
          return entry.path == path || entry.path.parent_path() == path;
        }))
      out.push_back(path);
  return out;
}

Problem no_shelf(const fs::path& folder, const std::error_code& error) {
  return {folder.string(), "the shelf cannot be opened: " + error.message() + ".",
          "Name a folder of vessels that the kiosk can read."};
}

Problem too_many(const fs::path& folder, std::size_t vessels) {
  return {folder.string(),
          "the shelf has " + std::to_string(vessels) + " vessels, and the kiosk shows " +
              std::to_string(kMostOnShelf) + " at the most, the first of them.",
          "Move vessels to another folder, for another exhibit."};
}

std::string mm(double metres) { return std::to_string(std::lround(1000.0 * metres)) + " mm"; }

/// Compares the drawing, the published sizes and the mesh.
void check_sizes(const fs::path& toml, const Pack& pack, const Vessel& vessel, ShelfCheck& check) {
  const Dimensions d = dimensions(vessel.extracted.profile);
  if (pack.true_height > 0.0 && pack.true_diameter > 0.0 &&
      std::abs(d.belly - pack.true_diameter) > 0.03 * pack.true_diameter)
    check.problems.push_back({toml.string(),
                              "at " + mm(pack.true_height) + " tall the mesh is " + mm(d.belly) +
                                  " wide, but true_diameter_mm is " + mm(pack.true_diameter) + ".",
                              "Correct true_diameter_mm or the mesh. Leave the key out if you "
                              "measured over the handles."});
}

void check_pack(const fs::path& folder, const LoadOptions& options,
                const std::vector<std::string>& languages, ShelfCheck& check) {
  const fs::path toml = folder / "vessel.toml";
  const PackRead read = read_pack(toml, languages);
  check.files.push_back(toml);
  check.keys_checked += read.keys_checked;
  check.problems.insert(check.problems.end(), read.problems.begin(), read.problems.end());
  check.problems.insert(check.problems.end(), read.advice.begin(), read.advice.end());
  if (!read.pack.drawing.empty()) {
    const DrawingRead drawing = check_drawing(folder / read.pack.drawing);
    check.files.push_back(folder / read.pack.drawing);
    check.keys_checked += drawing.keys_checked;
    check.problems.insert(check.problems.end(), drawing.problems.begin(), drawing.problems.end());
  }
  if (!read.pack.decoration.empty()) {
    const auto decoration = decoration::check_decoration(folder / read.pack.decoration);
    check.files.push_back(folder / read.pack.decoration);
    check.keys_checked += decoration.keys_checked;
    check.problems.insert(check.problems.end(), decoration.problems.begin(),
                          decoration.problems.end());
  }
  if (!read.problems.empty()) return;  // load_vessel would repeat the first of them
  const auto vessel = load_vessel(folder, options);
  if (!vessel) {
    check.problems.push_back(vessel.error());
    return;
  }
  check.files.push_back(vessel->file);
  if (!read.pack.decoration.empty() && vessel->coloring.pictures.empty())
    check.problems.push_back(
        {toml.string() + ", decoration",
         "The model has no picture, so the vessel stands there plain.",
         "Bake it: onggi vessel make PROFILE --decoration DECORATION -o MODEL"});
  check_sizes(toml, read.pack, *vessel, check);
}

/// Checks an unfinished pack of a shelf: a note says how much is left to do.
void count_gaps(const Entry& entry, const LoadOptions& options,
                const std::vector<std::string>& languages, ShelfCheck& check) {
  ShelfCheck own;
  check_pack(entry.path, options, languages, own);
  check.hidden.push_back(entry.id);
  check.files.insert(check.files.end(), own.files.begin(), own.files.end());
  check.keys_checked += own.keys_checked;
  const std::size_t gaps = own.problems.size();
  const std::string left = gaps == 0   ? "Nothing is missing."
                           : gaps == 1 ? "1 thing is missing."
                                       : std::to_string(gaps) + " things are missing.";
  const std::string remove =
      "take the tick from Unfinished at its label on the staff's page, or remove the line "
      "unfinished = true from its vessel.toml.";
  check.notes.push_back({entry.path.string(),
                         "This vessel is unfinished, so visitors do not see it. " + left,
                         gaps == 0 ? "To show it, " + remove
                                   : "Its label on the staff's page and onggi check " +
                                         entry.path.string() + " name them. Then " + remove});
}

}  // namespace

Result<void> read_shelf(const fs::path& folder, ShelfWatcher& watcher,
                        const settings::ReaderLimits& limits, const Arrangement& arrangement) {
  LoadOptions options;
  options.limits = limits;
  options.for_screen = true;
  std::error_code error;
  std::vector<Entry> entries = arranged(entries_of(folder, error), arrangement);
  if (error) return tl::unexpected<Problem>(no_shelf(folder, error));
  std::erase_if(entries, [](const Entry& entry) { return is_unfinished(entry.path); });
  if (entries.size() > kMostOnShelf) entries.resize(kMostOnShelf);
  std::atomic<std::size_t> next{0};
  std::mutex one_at_a_time;
  const auto work = [&] {
    for (std::size_t i = next++; i < entries.size(); i = next++) {
      {
        const std::lock_guard lock(one_at_a_time);
        watcher.begins(i, entries.size(), entries[i].id);
      }
      LoadOptions own = options;
      own.id = entries[i].id;
      auto read = load_vessels(entries[i].path, own);
      if (read) arrange(*read, arrangement);
      const std::lock_guard lock(one_at_a_time);
      watcher.has_read(i, std::move(read));
    }
  };
  const std::size_t helpers =
      std::min<std::size_t>(std::max(1u, std::thread::hardware_concurrency()), entries.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 1; i < helpers; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return {};
}

ShelfCheck check_shelf(const fs::path& path, const settings::ReaderLimits& limits,
                       const std::vector<std::string>& languages, std::stop_token stop,
                       const settings::Translations& translations, const Arrangement& arrangement) {
  ShelfCheck check;
  LoadOptions options;
  options.limits = limits;
  std::error_code error, ignored;
  std::vector<Entry> entries;
  if (fs::exists(path / "vessel.toml", ignored) || fs::is_regular_file(path, ignored))
    entries.push_back({path.filename().string(), path});
  else
    entries = entries_of(path, error);
  if (error) check.problems.push_back(no_shelf(path, error));
  for (const fs::path& folder : empty_folders(path, entries))
    check.problems.push_back({folder.string(), "This folder of the shelf contains no vessel.",
                              "Put its vessel.glb and vessel.toml there, or remove the folder."});
  entries = arranged(std::move(entries), arrangement, &check.hidden);
  for (const Entry& entry : entries) {
    if (stop.stop_requested()) break;
    if (fs::is_directory(entry.path, ignored)) {
      std::vector<std::string> own = languages;
      std::erase_if(own, [&](const std::string& code) {
        return translations.find(code, "vessel", entry.id, "title") != nullptr;
      });
      if (entry.path != path && is_unfinished(entry.path)) {
        count_gaps(entry, options, own, check);
        continue;
      }
      check.ids.push_back(entry.id);
      check_pack(entry.path, options, own, check);
      if (check.problems.empty() && is_unfinished(entry.path))
        check.problems.push_back({(entry.path / "vessel.toml").string(),
                                  "Nothing is missing, but visitors do not see this vessel yet.",
                                  "Remove the line unfinished = true."});
      continue;
    }
    check.files.push_back(entry.path);
    LoadOptions own = options;
    own.id = entry.id;
    auto vessels = load_vessels(entry.path, own);
    if (!vessels) {
      check.ids.push_back(entry.id);
      check.problems.push_back(vessels.error());
      continue;
    }
    // A document was read to find the scan that it names.
    if (vessels->front().file != entry.path) check.files.push_back(vessels->front().file);
    arrange(*vessels, arrangement, &check.hidden);
    for (const Vessel& vessel : *vessels) check.ids.push_back(vessel.id);
  }
  if (check.ids.size() > kMostOnShelf) check.problems.push_back(too_many(path, check.ids.size()));
  return check;
}

}  // namespace onggi::content
