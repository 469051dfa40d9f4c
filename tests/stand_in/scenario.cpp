#include "tests/stand_in/world.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "tests/stand_in/simulated_handle.h"
#include "tests/stand_in/simulated_others.h"
#include "tests/stand_in/simulated_puck.h"

// What a scenario says (README.md) becomes a world. It alone knows every simulated device.
namespace onggi::stand_in {

namespace {

Fault fault_of(const std::string& name) {
  constexpr std::pair<const char*, Fault> kNames[] = {
      {"unplug", Fault::unplug}, {"stall", Fault::stall},   {"flip", Fault::flip},
      {"short", Fault::shorten}, {"replay", Fault::replay}, {"reorder", Fault::reorder},
      {"deaf", Fault::deafen}};
  for (const auto& [known, fault] : kNames)
    if (name == known) return fault;
  throw std::runtime_error("there is no fault " + name);
}

/// `device KIND [word...] [track FILE START] [plug MS]`
void plug_one(World& world, std::istringstream& words) {
  std::string kind, word;
  words >> kind;
  Track track;
  long plugged = 0, from = 1000, click = 0;
  int x = 128, y = 128, tenths = 0, tilt = 0, counts = 3600;
  std::vector<long> clicks;
  bool combined = false, bluetooth = false;
  while (words >> word) {
    std::string file;
    long start = 0;
    if (word == "track" && words >> file >> start)
      track = Track::read(file, start);
    else if (word == "plug" && words >> plugged)
      continue;
    else if (word == "stick" && words >> x >> y)
      continue;
    else if (word == "turn" && words >> tenths >> from)
      continue;
    else if (word == "click" && words >> click)
      clicks.push_back(click);
    else if (word == "counts" && words >> counts)
      continue;
    else if (word == "tilt" && words >> tilt >> from)
      continue;
    else if (word == "combined")
      combined = true;
    else if (word == "bluetooth")
      bluetooth = true;
    else
      throw std::runtime_error("device " + kind + " does not know " + word);
  }
  std::unique_ptr<SimulatedDevice> made;
  if (kind == "space_mouse")
    made = std::make_unique<SimulatedPuck>(
        combined ? SimulatedPuck::Reports::combined : SimulatedPuck::Reports::split, track);
  else if (kind == "surface_dial")
    made = std::make_unique<SimulatedDial>(tenths, from, clicks, counts);
  else if (kind == "dual_sense")
    made = std::make_unique<SimulatedController>(bluetooth, x, y, tilt, from);
  else if (kind == "polhem")
    made = std::make_unique<SimulatedArm>(track);
  else if (kind == "onggi_hid")
    made = std::make_unique<SimulatedHandle>(track);
  else
    throw std::runtime_error("there is no device " + kind);
  Socket& socket = world.plug(std::move(made));
  socket.plugged_at = plugged;
  socket.present = plugged == 0;
}

}  // namespace

std::unique_ptr<World> World::read(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file + ": no such scenario");
  auto world = std::make_unique<World>();
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string word, what;
    if (!(words >> word)) continue;
    if (word == "clock" && words >> what && (what == "reads" || what == "real")) {
      world->clock = what == "reads" ? Clock::reads : Clock::real;
    } else if (word == "record") {
      words >> world->record_file;
    } else if (word == "device") {
      plug_one(*world, words);
    } else if (PlannedFault fault;
               word == "fault" && !world->sockets_.empty() && words >> fault.at >> what) {
      fault.fault = fault_of(what);
      words >> fault.lasts;
      world->sockets_.back()->faults.push_back(fault);
    } else {
      throw std::runtime_error(file + ": not understood: " + line);
    }
  }
  return world;
}

}  // namespace onggi::stand_in
