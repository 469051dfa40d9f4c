#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "kiosk/wheel/device/hid_port.h"
#include "tests/stand_in/simulated_device.h"

namespace onggi::stand_in {

/// What goes wrong on a device's way, once.
enum class Fault : std::uint8_t {
  unplug,   ///< For `lasts` ms; then it is there again.
  stall,    ///< It sends nothing.
  flip,     ///< A bit of each report is turned over.
  shorten,  ///< Each report lacks its last byte.
  replay,   ///< The last report before it again and again.
  reorder,  ///< Two by two the wrong way round.
  deafen,   ///< What it is told does not arrive.
};

struct PlannedFault {
  long at = 0;     ///< ms of the device's time.
  long lasts = 1;  ///< ms
  Fault fault = Fault::stall;
};

/// What went over a wire.
struct WireRecord {
  long at = 0;  ///< ms of the device's time.
  bool out = false;
  Bytes bytes;
};

/// A socket with a simulated device in it. Time passes for it a millisecond a tick.
struct Socket {
  std::string path;
  std::unique_ptr<SimulatedDevice> device;
  std::vector<PlannedFault> faults;
  long plugged_at = 0;  ///< ms: it comes only then.

  long ms = 0;
  bool present = true;
  unsigned plugs = 0;  ///< Counts the times that it came: a handle of before is dead.
  std::vector<Bytes> waiting;
  Bytes before, kept;
  const PlannedFault* under(Fault fault) const;
};

/// All that is plugged in, as a bus; turned by the reads of whoever uses it (each read that finds
/// nothing is a millisecond: a scripted clock), or by the real time.
class World {
 public:
  enum class Clock : std::uint8_t { reads, real };

  /// From a file: the grammar stands in tests/stand_in/README.md. Throws std::runtime_error.
  static std::unique_ptr<World> read(const std::string& file);
  ~World();

  Socket& plug(std::unique_ptr<SimulatedDevice> device, std::vector<PlannedFault> faults = {});
  std::vector<device::HidListing> list();
  /// A number for the present plugging of `path`; -1 where nothing is.
  int open(const std::string& path);
  int read(int handle, std::uint8_t* into, std::size_t size, int timeout_ms);
  bool write(int handle, const std::uint8_t* bytes, std::size_t size);
  int feature(int handle, std::uint8_t* into, std::size_t size);
  void close(int handle);

  Clock clock = Clock::reads;
  long away_ms = 1000;  ///< By reads: what passes for a device that is not there at each list().
  bool keeps = false;   ///< Keep what goes over the wires in `record`,
  std::vector<WireRecord> record;
  std::string record_file;  ///< or write it here, each as it goes.

 private:
  struct Handle {
    Socket* socket = nullptr;
    unsigned plug = 0;
    bool open = false;
  };
  Socket* socket_of(int handle);
  void pass(Socket& socket, long ms);
  void catch_up();
  void note(const Socket& socket, bool out, const Bytes& bytes);

  std::mutex mutex_;
  std::vector<std::unique_ptr<Socket>> sockets_;
  std::vector<Handle> handles_;
  std::int64_t began_ns_ = -1;
  std::FILE* file_ = nullptr;
};

/// The world as a HidBus, for tests that link it. `world` outlives it and its ports.
std::unique_ptr<device::HidBus> bus_of(World& world);

}  // namespace onggi::stand_in
