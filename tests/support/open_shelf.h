#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kiosk/collection/content/catalogue.h"

// A whole shelf at once. The kiosk shows each vessel as it is read, and needs no such list.

namespace onggi::content {

/// The vessels that loaded, in the order of the shelf, and why the others did not.
struct OpenedShelf {
  std::vector<Vessel> vessels;
  std::vector<Problem> problems;
  std::size_t entries = 0;  ///< Those that read_shelf() told, good or not.
  const Vessel* find(const std::string& id) const {
    const auto found = std::ranges::find(vessels, id, &Vessel::id);
    return found == vessels.end() ? nullptr : &*found;
  }
};

inline OpenedShelf open_shelf(const std::filesystem::path& folder,
                              const Arrangement& arrangement = {}) {
  struct Collector : ShelfWatcher {
    void begins(std::size_t, std::size_t total, const std::string&) override {
      loaded.resize(total);
      ++begun;
    }
    void has_read(std::size_t at, Result<std::vector<Vessel>> read) override {
      loaded[at] = std::move(read);
    }
    std::vector<std::optional<Result<std::vector<Vessel>>>> loaded;
    std::size_t begun = 0;
  } collector;
  OpenedShelf out;
  if (auto good = read_shelf(folder, collector, {}, arrangement); !good)
    out.problems.push_back(good.error());
  out.entries = collector.begun;
  for (auto& loaded : collector.loaded) {
    if (!*loaded) {
      out.problems.push_back(loaded->error());
      continue;
    }
    for (Vessel& vessel : **loaded) out.vessels.push_back(std::move(vessel));
  }
  return out;
}

}  // namespace onggi::content
