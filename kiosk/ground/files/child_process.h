#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/descriptor.h"

namespace onggi::files {

/// Both ends of a pipe or socket pair: ours does not block, neither outlives an exec by accident.
struct Channel {
  Descriptor ours, theirs;
  /// What we write goes through a socket: send() can leave SIGPIPE out, write() cannot.
  bool open_for_writing();
  bool open_for_reading();
};

/// A child until it has been waited for: killed and waited for on every way out. The one way in
/// which the kiosk starts another program.
class ChildProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// Where its standard streams lead; -1: nowhere.
  struct Streams {
    int in = -1, out = -1, err = -1;
  };
  /// Starts `program` (a path, or a name to be found in PATH) with `arguments`. It inherits nothing
  /// but its three streams and the environment, no blocked or ignored signal. Changes no signal of
  /// this process, and stops no thread of it, as a fork would. errno's value where it cannot.
  static tl::expected<ChildProcess, int> start(const std::string& program,
                                               const std::vector<std::string>& arguments,
                                               const Streams& streams);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ~ChildProcess();

  /// Sends it `signal` (one that ends it) and waits; what has not ended within `patience` seconds
  /// is killed.
  void end(int signal, double patience = 60.0);
  /// True once it has ended; false at `deadline`.
  bool wait_until(Clock::time_point deadline);
  /// Seconds of processor time that it has had so far; 0 once it has been waited for.
  double processor_seconds() const;
  /// As waitpid() tells it, once it has ended.
  int status() const { return status_; }

 private:
  explicit ChildProcess(pid_t pid) : pid_(pid) {}
  pid_t pid_;
  int status_ = 0;
};

}  // namespace onggi::files
