#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/lab/measure/effect_prices.h"
#include "kiosk/picture/drawing/plot.h"

namespace onggi::measure {

/// The cost of each effect and each scene: the report of `onggi lab effects`.
struct PriceList {
  int rows = 400, sectors = 360;
  std::vector<EffectPrice> prices;  ///< Bytes: beyond those of the first.
};

/// The scenes of priced_scenes(), with the presets of the program's config/scenes before the last
/// one.
Result<std::vector<PricedScene>> scenes_with_presets(int rows, int sectors);

/// Measures them one by one, each `passes` times, and prints a line for each to `table`. With
/// `count` and if valgrind is installed, it runs this program again under valgrind to count the
/// instructions of a tick. Takes minutes; not for the 1 kHz thread.
Result<PriceList> measure_prices(const std::vector<PricedScene>& scenes, int rows, int sectors,
                                 int passes, bool count, std::FILE* table);

/// Why its times cannot be believed, as whole sentences: an effect came out cheaper than none, so
/// something else kept the machine busy. Empty if nothing speaks against them.
std::string doubt_of(const PriceList& list);

files::Json json_of(const PriceList& list);
drawing::Plot plot_of(const PriceList& list);

}  // namespace onggi::measure
