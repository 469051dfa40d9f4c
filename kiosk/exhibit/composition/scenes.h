#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "engine/scene/scene_def.h"
#include "kiosk/collection/content/glaze.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/collection/decoration/way.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/tuning/background_tuner.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::exhibit {

/// The clay of each vessel of an exhibit, what attract mode shows of it, the glazes, and the ways
/// to decorate. Main thread; not movable, because screens point at its glazes and ways.
class Scenes {
 public:
  /// Reads the exhibit's scene, those of single vessels, the glazes if a scene has a kiln, and the
  /// ways if visitors may decorate.
  /// Problems are logged, and the rest is used.
  explicit Scenes(const settings::Exhibit& exhibit);
  ~Scenes();
  Scenes(const Scenes&) = delete;
  Scenes& operator=(const Scenes&) = delete;

  /// Scenes with quality = "auto" get the grid that `folder` remembers for this machine; a
  /// background thread finds the others one by one.
  void tune(const std::filesystem::path& folder, const tuning::TunePlan& plan = {});
  /// Takes grids that the thread has found, for the next pot, and saves them. Never waits.
  void take_up_tuned();

  /// The scene of vessel `id` on the shelf, with the exhibit's share of force.
  const SceneDef& of(const std::string& id) const;
  /// The one in which `vessel` may be built of coils; null: it is only thrown.
  const SceneDef* built(const content::Vessel& vessel) const;
  /// Of its scene, for the screens.
  screens::SceneForVisitor wheel_of(const content::Vessel& vessel) const {
    return for_visitor(of(vessel.id), vessel);
  }
  /// The part of a scene of `vessel` that the screens need, with its way and its glazes first.
  screens::SceneForVisitor for_visitor(const SceneDef& def, const content::Vessel& vessel) const;
  const std::vector<content::Glaze>& glazes() const { return glazes_; }

 private:
  // A scene whose grid must be found here.
  struct ToTune {
    SceneDef* def;
    std::filesystem::path file, memory;
  };
  void take(const settings::Exhibit& exhibit, SceneDef& def, const std::filesystem::path& file);
  void tune_next();
  /// All glazes' indices, `own` first.
  std::vector<int> in_order(const std::vector<std::string>& own) const;
  /// The way of that vessel, or the usual one; null where there is none. Says in the log once a
  /// vessel what is not as it should be.
  const decoration::Way* way_of(const content::Vessel& vessel) const;

  SceneDef exhibits_;
  std::map<std::string, SceneDef> vessels_;
  std::unique_ptr<SceneDef> built_;
  std::vector<ToTune> to_tune_;  // the first is in work while tuner_ exists
  std::unique_ptr<tuning::BackgroundTuner> tuner_;
  std::string machine_;
  tuning::TunePlan plan_;
  std::vector<content::Glaze> glazes_;
  std::map<std::string, decoration::Way> ways_;
  bool decorates_ = false;
  mutable std::set<std::string> said_;  ///< Vessels whose way was complained about.
  std::vector<std::string> attract_scripts_;
};

/// Gives `def`'s potter the paddle of `vessel`'s makers, if that is known and `def` has a paddle.
/// With a face that leaves prints, [prints] begins.
void take_paddle(SceneDef& def, const content::Vessel& vessel);

/// Unknown names in the exhibit: vessels in `order`, `hidden` and [vessel_scenes] that are not
/// among the shelf's `ids` (hidden ones too), scripts in [attract], and a `built_scene` without
/// coils. In file order.
settings::Problems unknown_names(const settings::Exhibit& exhibit,
                                 const std::vector<std::string>& ids);

}  // namespace onggi::exhibit
