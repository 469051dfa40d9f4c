#pragma once

#include <string>

#include "kiosk/ground/web/message.h"
#include "kiosk/program/console/scene_prices.h"
#include "kiosk/program/console/site.h"

namespace onggi::console {

/// The part of the staff's page that tells of scenes. They are changed as any file (EditAnswers).
/// One thread; reads the disk.
class SceneAnswers {
 public:
  /// `site` stays with the caller.
  SceneAnswers(Site& site, ScenePrices prices) : site_(site), prices_(std::move(prices)) {}

  /// The files in `scenes` beside the exhibit's own: [{name, words: what the file says of itself,
  /// effects, thrown, built: visitors throw or build with it, vessels: that have it as their own,
  /// tick_us: absent where it is not known}]
  web::Answer scenes(const web::Ask& ask);
  /// {measuring, trouble, prices: null before they are known, budget: share of a tick that clay may
  /// take, grid: what `quality = "auto"` chose, in words} of the scene `name`. What is not known is
  /// measured then.
  web::Answer prices(const web::Ask& ask, const std::string& name);
  /// Measures it anew.
  web::Answer measure(const std::string& name);

 private:
  Site& site_;
  ScenePrices prices_;
};

}  // namespace onggi::console
