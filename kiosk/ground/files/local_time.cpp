#include "kiosk/ground/files/local_time.h"

#include <algorithm>

namespace onggi::files {

std::string local_time(std::time_t at, const char* format) {
  std::tm local{};
  localtime_r(&at, &local);
  char text[64];
  return {text, std::strftime(text, sizeof text, format, &local)};
}

bool begins_like(std::string_view text, std::string_view pattern) {
  return text.size() > pattern.size() &&
         std::equal(pattern.begin(), pattern.end(), text.begin(),
                    [](char p, char c) { return p == '9' ? c >= '0' && c <= '9' : c == p; });
}

LocalMoment local_moment(std::time_t at) {
  std::tm local{};
  localtime_r(&at, &local);
  return {local.tm_year + 1900, local.tm_mon + 1, local.tm_mday, local.tm_hour * 60 + local.tm_min};
}

}  // namespace onggi::files
