#include "kiosk/ground/files/printed.h"

#include <iostream>

namespace onggi::files {

Result<void> all_printed() {
  std::cout.flush();
  if (std::cout) return {};
  return problem("standard output", "Not everything that was printed could be written.",
                 "Free some space on its disk, or let its reader read to the end.", 1);
}

}  // namespace onggi::files
