#pragma once

#include <string>

#include "kiosk/collection/content/vessel.h"
#include "kiosk/ground/cli/command.h"

namespace onggi::commands {

/// The option --up, which tries another up than the one that was found, as `up =` does.
cli::Option up_option(std::string& word);

/// Takes what stands there into `options`; nothing for an empty word, a Problem for no axis.
Result<void> take_up(const std::string& word, content::LoadOptions& options);

}  // namespace onggi::commands
