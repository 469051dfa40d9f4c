#include "kiosk/commands/put_report.h"

#include <iostream>
#include <span>

#include "kiosk/files/durable_file.h"

namespace onggi::commands {

Result<bool> put_report(const files::Json& report, const std::string& where) {
  if (where.empty()) return true;
  const std::string text = report.text() + "\n";
  if (where == "-") {
    std::cout << text;
    return false;
  }
  return files::write_durably(where, std::as_bytes(std::span(text))).map([] { return true; });
}

}  // namespace onggi::commands
