#include "kiosk/commands/put_report.h"

namespace onggi::commands {

Result<bool> put_report(const files::Json& report, const files::Output& output) {
  if (!output.wanted()) return true;
  return output.write(report.text() + "\n").map([&output] { return !output.to_stdout(); });
}

}  // namespace onggi::commands
