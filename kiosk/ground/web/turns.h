#pragma once

#include <deque>
#include <functional>
#include <string>
#include <unordered_map>

namespace onggi::web {

/// Work that waits for the server's one thread, by the address that it is for. The addresses take
/// turns, a piece of work each, so thousands of downloads from one address make a phone at another
/// wait for one piece of theirs. Uses no socket. One thread.
class Turns {
 public:
  using Work = std::function<void()>;

  /// May be called by work.
  void add(const std::string& address, Work work);
  /// Does a piece of the address whose turn it is. Nothing if no work waits.
  void next();
  bool empty() const { return order_.empty(); }

 private:
  std::unordered_map<std::string, std::deque<Work>> waiting_;
  std::deque<std::string> order_;  // the keys of waiting_; the first is next
};

}  // namespace onggi::web
