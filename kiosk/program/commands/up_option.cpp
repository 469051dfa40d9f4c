#include "kiosk/program/commands/up_option.h"

#include "engine/base/plain_text.h"
#include "kiosk/collection/content/pack.h"

namespace onggi::commands {

cli::Option up_option(std::string& word) {
  return {"--up", &word,
          "The file's axis that points to the rim, as `up =` in vessel.toml: x, y, z, or --up=-z "
          "[found]"};
}

Result<void> take_up(const std::string& word, content::LoadOptions& options) {
  if (word.empty()) return {};
  options.up = content::axis_called(word);
  if (options.up) return {};
  return problem("--up " + terminal::plain(word.substr(0, 20)), "this is not an axis.",
                 "Write the file's axis that points to the rim: x, y, z, =-x, =-y or =-z.");
}

}  // namespace onggi::commands
