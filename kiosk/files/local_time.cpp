#include "kiosk/files/local_time.h"

namespace onggi::files {

std::string local_time(std::time_t at, const char* format) {
  std::tm local{};
  localtime_r(&at, &local);
  char text[64];
  return {text, std::strftime(text, sizeof text, format, &local)};
}

}  // namespace onggi::files
