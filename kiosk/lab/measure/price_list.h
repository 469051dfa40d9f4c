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

/// What each effect and each scene costs: the report of `onggi lab effects`.
struct PriceList {
  int rows = 400, sectors = 360;
  std::vector<EffectPrice> prices;  ///< Bytes: beyond those of the first.
};

/// The scenes of priced_scenes(), and before its last the presets that lie in config/scenes of the
/// program.
Result<std::vector<PricedScene>> scenes_with_presets(int rows, int sectors);

/// Measures them one by one, each of `passes` times; a line each is printed to `table`. Where
/// `count` is set and valgrind is here, this program is run again under it to count the
/// instructions of a tick. Minutes; not for the 1 kHz thread.
Result<PriceList> measure_prices(const std::vector<PricedScene>& scenes, int rows, int sectors,
                                 int passes, bool count, std::FILE* table);

files::Json json_of(const PriceList& list);
drawing::Plot plot_of(const PriceList& list);

}  // namespace onggi::measure
