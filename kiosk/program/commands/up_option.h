#pragma once

#include <string>

#include "kiosk/collection/content/vessel.h"
#include "kiosk/ground/cli/command.h"

namespace onggi::commands {

/// The option --up, which sets the upright direction instead of finding it, like `up =`.
cli::Option up_option(std::string& word);

/// Parses the option into `options`; does nothing for an empty word. Problem if it is not an axis.
Result<void> take_up(const std::string& word, content::LoadOptions& options);

}  // namespace onggi::commands
