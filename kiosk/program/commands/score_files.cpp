#include "kiosk/program/commands/score_files.h"

#include <memory>

#include "engine/profile/extraction.h"
#include "kiosk/collection/content/drawing.h"
#include "kiosk/collection/content/model.h"
#include "kiosk/collection/content/vessel.h"
#include "kiosk/ground/files/replay_file.h"

namespace fs = std::filesystem;

namespace onggi::commands {

namespace {

Result<Shape> read_vessel(const fs::path& path, const std::string& node) {
  content::LoadOptions options;
  options.node = node;
  const auto vessel = content::load_vessel(path, options);
  if (!vessel) return tl::unexpected(vessel.error());
  Shape shape;
  shape.file = path.string();
  shape.node = vessel->node;
  shape.kind = "vessel";
  shape.profile = vessel->extracted.profile;
  shape.true_size = content::is_known(vessel->size_from);
  return shape;
}

/// Process a drawing like its mesh, so that both give the same profile.
Result<Shape> read_drawing_shape(const fs::path& path) {
  const auto drawing = content::read_drawing(path);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto found = extract_profile(content::turned(*drawing), {}, path.string());
  if (!found) return tl::unexpected(found.error());
  return Shape{path.string(), "", "drawing", found->profile, true};
}

Result<Shape> read_thrown(const fs::path& path) {
  const auto replay = files::read_replay(path);
  if (!replay) return tl::unexpected(replay.error());
  std::unique_ptr<Scene> scene;
  const auto outcome = run_replay(*replay, &scene);
  if (!outcome) return tl::unexpected(outcome.error());
  return Shape{path.string(), "", "replay", scene->clay().profile(), true};
}

}  // namespace

Result<Shape> read_shape(const fs::path& file, const std::string& node) {
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    return problem(file.string(), "There is no file or folder with this name.",
                   "Name a GLB, a glTF, a vessel's folder, a drawing's TOML or a visit.onggi.");
  if (file.filename() == "vessel.toml") return read_vessel(fs::absolute(file).parent_path(), node);
  if (file.extension() == ".toml") return read_drawing_shape(file);
  if (file.extension() == ".onggi") return read_thrown(file);
  return read_vessel(file, node);
}

}  // namespace onggi::commands
