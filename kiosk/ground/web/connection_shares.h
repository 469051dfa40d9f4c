#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <unordered_map>

namespace onggi::web {

/// Which connections are open, by the address that they come from, and which one has to go when
/// one more comes. Uses no socket. A connection is silent until it has asked for something.
///   1. No address has more than its share: its own oldest silent one goes; if it has none, the
///      newcomer is refused.
///   2. If everything is taken, the oldest silent one of the address with the most silent ones
///      goes; of addresses with as many, the oldest of all.
///   3. If nobody is silent, the oldest one of the address with the most goes, where that is still
///      more than the newcomer's address has with it; else the newcomer is refused.
/// So many idle connections of one address cost no other address anything. One thread.
class ConnectionShares {
 public:
  using Number = std::uint64_t;  ///< Of a connection; later ones have larger numbers.

  /// `all` connections at once, 1 or more; of one address half of that.
  explicit ConnectionShares(std::size_t all) : all_(all < 1 ? 1 : all) {}
  ConnectionShares(const ConnectionShares&) = delete;
  ConnectionShares& operator=(const ConnectionShares&) = delete;

  struct Entry {
    Number in = 0;   ///< The newcomer's number; 0: it is refused.
    Number out = 0;  ///< The one to be closed for it, no longer counted; 0: none.
  };
  Entry enter(const std::string& address);
  /// It has asked for something.
  void asked(Number number);
  /// It is closed. One that is not counted, or not any more, is no mistake.
  void leave(Number number);

  std::size_t open() const { return addresses_of_.size(); }
  std::size_t share() const { return all_ < 2 ? 1 : all_ / 2; }
  /// How often two addresses' counts were compared since the start: the work, which hardly grows
  /// with the number of addresses.
  std::uint64_t compared() const { return compared_; }

 private:
  struct Address {
    std::set<Number> silent, asking;  // oldest first
    std::size_t all() const { return silent.size() + asking.size(); }
  };
  using Addresses = std::map<std::string, Address>;
  /// How many connections an address has, and the one that goes first.
  struct Count {
    std::size_t count;
    Number oldest;
    Addresses::iterator of;
  };
  /// The most first; of as many, whose connection is the oldest.
  struct MostFirst {
    std::uint64_t* compared;
    bool operator()(const Count& a, const Count& b) const {
      ++*compared;
      if (a.count != b.count) return a.count > b.count;
      return a.oldest != b.oldest ? a.oldest < b.oldest : a.of->first < b.of->first;
    }
  };
  using Counts = std::set<Count, MostFirst>;

  static Count silent_of(Addresses::iterator at);
  static Count all_of(Addresses::iterator at);
  /// Before and after each change of an address's connections: its counts leave, and come back.
  void take_counts(Addresses::iterator at);
  void put_counts(Addresses::iterator at);

  std::size_t all_;
  std::uint64_t compared_ = 0;
  Number last_ = 0;
  Addresses addresses_;
  Counts silent_{MostFirst{&compared_}}, most_{MostFirst{&compared_}};
  std::unordered_map<Number, std::string> addresses_of_;
};

}  // namespace onggi::web
