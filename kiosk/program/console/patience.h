#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

namespace onggi::console {

/// Slows down who tries passphrases: after each wrong one for a name from an address, the next must
/// wait, 1 s and then twice as long each time, up to 60 s. Nobody is ever locked out, and another
/// address waits for nothing. One thread; a fixed amount of memory.
class Patience {
 public:
  static constexpr std::int64_t kLongest = 60;  ///< s
  static constexpr std::size_t kMost = 1024;    ///< Pairs remembered; the longest quiet one goes.

  /// s until the next try is looked at; 0: now.
  std::int64_t wait(const std::string& name, const std::string& address, std::int64_t now) const;
  void wrong(const std::string& name, const std::string& address, std::int64_t now);
  void right(const std::string& name, const std::string& address);

 private:
  struct Tries {
    std::int64_t next = 0;  ///< When the next is looked at, s.
    std::int64_t pause = 0;
  };
  std::map<std::pair<std::string, std::string>, Tries> tries_;
};

}  // namespace onggi::console
