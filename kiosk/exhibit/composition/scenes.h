#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/scene/scene_def.h"
#include "kiosk/collection/content/glaze.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/tuning/background_tuner.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::exhibit {

/// How the clay behaves for each vessel of an exhibit, what attract mode shows of it, and what pots
/// may be glazed with. Main
/// thread; stays where it is, since screens look at its glazes.
class Scenes {
 public:
  /// Reads the exhibit's scene, those of single vessels, and the glazes where a scene has a kiln.
  /// Problems are logged, and what they leave is used.
  explicit Scenes(const settings::Exhibit& exhibit);
  ~Scenes();
  Scenes(const Scenes&) = delete;
  Scenes& operator=(const Scenes&) = delete;

  /// Scenes with quality = "auto" get the grid that is remembered for this machine in `folder`;
  /// those without one are given to a thread in the background, one by one.
  void tune(const std::filesystem::path& folder, const tuning::TunePlan& plan = {});
  /// Takes up what that thread has found since, for the next pot, and remembers it. Never waits.
  void take_up_tuned();

  /// Of the vessel called `id` on the shelf; with the exhibit's share of force.
  const SceneDef& of(const std::string& id) const;
  /// What the screens meet of it.
  screens::Wheel wheel_of(const std::string& id) const;
  const std::vector<content::Glaze>& glazes() const { return glazes_; }

 private:
  // A scene whose grid is to be found here.
  struct ToTune {
    SceneDef* def;
    std::filesystem::path file, memory;
  };
  void take(const settings::Exhibit& exhibit, SceneDef& def, const std::filesystem::path& file);
  void tune_next();

  SceneDef exhibits_;
  std::map<std::string, SceneDef> vessels_;
  std::vector<ToTune> to_tune_;  // the first is being looked for, while tuner_ is there
  std::unique_ptr<tuning::BackgroundTuner> tuner_;
  std::string machine_;
  tuning::TunePlan plan_;
  std::vector<content::Glaze> glazes_;
  std::vector<std::string> attract_scripts_;
};

/// What the exhibit names and nobody knows: vessels in [vessel_scenes] that are not on the shelf,
/// whose vessels are `ids`, and scripts in [attract]. In file order.
settings::Problems names_of_nothing(const settings::Exhibit& exhibit,
                                    const std::vector<std::string>& ids);

}  // namespace onggi::exhibit
