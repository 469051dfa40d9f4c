#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/json.h"

namespace onggi::measure {

/// What a frame of a decorated pot takes over one of the same pot plain. The pot fills the screen's
/// middle and turns, so that all of it is drawn anew; one sample a pixel, at half the frame's size,
/// as a machine without a GPU draws it. Plain and decorated frames alternate.
struct DecoratedFrames {
  int width = 0, height = 0;
  std::string way;    ///< That decorated it (content/ways), all its tools; "light": none, but the
                      ///< studio's window is dragged round the pot.
  std::string state;  ///< "dry", "wet slip", "firing", "fired".
  int pairs = 0;
  double plain_ms = 0, decorated_ms = 0;  ///< Medians, until the driver has drawn it.
  double over() const { return plain_ms > 0 ? decorated_ms / plain_ms - 1.0 : 0.0; }
};

/// Opens a hidden window of `size` in pixels; needs a display. `config`: exhibit.toml, whose ways
/// are measured: kMeasuredWays, as far as it has them. `pairs` of frames a row, 1 or more. Main
/// thread; about a minute.
Result<std::vector<DecoratedFrames>> measure_decorated(const std::filesystem::path& config,
                                                       std::pair<int, int> size, int pairs);

files::Json json_of(const DecoratedFrames& row);
/// With a header line; empty for no rows.
std::string text_of(const std::vector<DecoratedFrames>& rows);

}  // namespace onggi::measure
