// For tests/ends/run.py: what `onggi check` accepts, and a visit on it.
//   onggi_ends keys                              every key with its ends, as JSON
//   onggi_ends visit EXHIBIT KEEPSAKES MISSION   a whole visit (MISSION -1: of a vessel), as JSON
#include <cstdlib>
#include <iostream>
#include <string>

#include "tests/ends/keys.h"
#include "tests/ends/timed_visit.h"

int main(int count, char** words) {
  const std::string what = count > 1 ? words[1] : "";
  if (what == "keys" && count == 2) {
    std::cout << onggi::ends::every_key().text() << '\n';
    return 0;
  }
  if (what == "visit" && count == 5) {
    std::cout << onggi::ends::timed_visit({words[2], words[3], std::atoi(words[4])}).text() << '\n';
    return 0;
  }
  std::cerr << "usage: onggi_ends keys | onggi_ends visit EXHIBIT KEEPSAKES MISSION\n";
  return 2;
}
