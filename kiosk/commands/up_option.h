#pragma once

#include <string>

#include "kiosk/cli/command.h"
#include "kiosk/content/vessel.h"

namespace onggi::commands {

/// The option --up, which tries another up than the one that was found, as `up =` does.
cli::Option up_option(std::string& word);

/// Takes what stands there into `options`; nothing for an empty word, a Problem for no axis.
Result<void> take_up(const std::string& word, content::LoadOptions& options);

}  // namespace onggi::commands
