#include "kiosk/program/commands/card_on_shelf.h"

#include <cstddef>
#include <vector>

#include "engine/base/nearest_name.h"

namespace onggi::commands {

Result<int> card_on_shelf(exhibit::Shelf& shelf, const std::string& searched,
                          const std::string& id) {
  const auto& cards = shelf.cards();
  if (cards.empty()) {
    // A single refused file has its own reason; a shelf without vessels has none.
    if (id.empty() && !shelf.problems().empty()) return tl::unexpected(shelf.problems().front());
    return problem(searched, "No vessel there could be opened.",
                   "Name a GLB or glTF file, or run onggi check " + searched + ".");
  }
  if (id.empty()) return 0;
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < cards.size(); ++i) {
    if (cards[i].vessel->id == id) return static_cast<int>(i);
    ids.push_back(cards[i].vessel->id);
  }
  const std::string nearest = nearest_name(id, ids);
  return problem("--vessel " + id,
                 "No such file, and no such vessel on the shelf " + searched + ".",
                 (nearest.empty() ? "" : "Did you mean " + nearest + "? ") +
                     ("There are: " + joined(ids) + "."));
}

}  // namespace onggi::commands
