#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/descriptor.h"

namespace onggi::files {

/// Both ends of a pipe or socket pair. Our end does not block; both close on exec.
struct Channel {
  Descriptor ours, theirs;
  /// Uses a socket for writing: send() can suppress SIGPIPE, write() cannot.
  bool open_for_writing();
  bool open_for_reading();
};

/// A child process that is always killed and waited for when this object goes. Every program that
/// the kiosk starts is started here.
class ChildProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// Descriptors of its standard streams; -1: none.
  struct Streams {
    int in = -1, out = -1, err = -1;
  };
  /// Starts `program` (a path, or a name in PATH) with `arguments`. The child inherits only its
  /// three streams and the environment, with no signal blocked or ignored. Unlike fork(), this
  /// stops no thread and changes no signal of this process. Returns errno's value on failure.
  static tl::expected<ChildProcess, int> start(const std::string& program,
                                               const std::vector<std::string>& arguments,
                                               const Streams& streams);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ~ChildProcess();

  /// Sends `signal` (one that ends it) and waits. Kills the child if it has not ended within
  /// `patience` seconds.
  void end(int signal, double patience = 60.0);
  /// Waits until the child ends (true) or until `deadline` (false).
  bool wait_until(Clock::time_point deadline);
  /// Processor time of the child, s; 0 after it was waited for.
  double processor_seconds() const;
  /// The status from waitpid(), after the child ended.
  int status() const { return status_; }

 private:
  explicit ChildProcess(pid_t pid) : pid_(pid) {}
  pid_t pid_;
  int status_ = 0;
};

}  // namespace onggi::files
