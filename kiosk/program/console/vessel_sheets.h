#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "kiosk/program/console/onggi_process.h"

namespace onggi::console {

/// The sheets of vessels: section and view, as archaeologists draw them, and their outlines. `onggi
/// vessel inspect` draws one in a process of its own; the newest are kept. One thread; never waits
/// for a drawing.
class VesselSheets {
 public:
  static constexpr std::size_t kKept = 400;  ///< Files; of about 300 kB with their outlines.

  /// `onggi`: the program beside this one. `folder`: of its own; made when it is needed.
  VesselSheets(std::filesystem::path onggi, std::filesystem::path folder)
      : drawing_(std::move(onggi)), folder_(std::move(folder)) {}

  struct Sheet {
    std::string png;      ///< Its bytes; "": not there yet.
    std::string outline;  ///< An SVG: the vessel from the side (side_view()).
    std::string trouble;  ///< Why it will not be; "": it is being drawn, or waits for another.
  };
  /// The sheet of the vessel in the folder `vessel`, as its files are now.
  Sheet of(const std::filesystem::path& vessel);

 private:
  void take();

  OnggiProcess drawing_;
  std::filesystem::path folder_, wanted_;                // wanted_: the file that is being drawn
  std::map<std::filesystem::path, std::string> failed_;  // why, by the sheet's file
};

}  // namespace onggi::console
