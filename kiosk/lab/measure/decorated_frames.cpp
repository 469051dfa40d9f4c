#include "kiosk/lab/measure/decorated_frames.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

#include "engine/clay/clay_view.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/ways.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/lab/measure/middle.h"
#include "kiosk/picture/render/canvas.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/decorating/decorated_pot.h"

namespace onggi::measure {
namespace {

constexpr std::array<const char*, 3> kMeasuredWays{"celadon", "onggi", "slip_painted"};
constexpr double kPotTall = 0.18, kWidest = 0.067;      // m
constexpr double kScaleWithoutGpu = 0.5, kTurn = 0.05;  // rad a frame
constexpr int kFirst = 4;                               // frames that are not counted

double belly_of_jar(double t) { return 0.045 + 0.022 * std::sin(3.0 * t); }

/// A jar with a wall of 6 mm.
ClayView jar() {
  ClayDef grid;
  grid.rows = 240;
  grid.sectors = 256;
  grid.height = kPotTall;
  ClayView clay;
  clay.lay(grid);
  std::vector<float> outer(static_cast<std::size_t>(grid.sectors)), inner(outer.size());
  for (int j = 0; j < grid.rows; ++j) {
    const double r = belly_of_jar(clay.row_height(j) / kPotTall);
    outer.assign(outer.size(), static_cast<float>(r));
    inner.assign(inner.size(), j < clay.floor_rows() ? 0.0f : static_cast<float>(r - 0.006));
    clay.shape(j, outer, inner);
  }
  return clay;
}

/// All tools of the way in their order, each once, one above the other.
void use_every_tool(decorating::DecoratedPot& pot) {
  const auto tools = static_cast<int>(pot.way().tools.size());
  for (int tool = 0; tool < tools; ++tool) {
    pot.choose_tool(tool);
    pot.put({pot.outside() * (0.2 + 0.6 * tool / tools), 0.0});
    pot.end_work();
  }
  pot.finish();
}

/// Draws one pot, plain and decorated.
class Studio {
 public:
  static Result<std::unique_ptr<Studio>> open(std::pair<int, int> size) {
    render::WindowOptions window;
    window.width = size.first;
    window.height = size.second;
    window.visible = false;
    auto renderer = render::Renderer::create(window);
    if (!renderer) return tl::unexpected(renderer.error());
    auto stage = render::Stage::create();
    if (!stage) return tl::unexpected(stage.error());
    auto items = render::ItemPainter::create();
    if (!items) return tl::unexpected(items.error());
    return std::unique_ptr<Studio>(
        new Studio(size, std::move(*renderer), std::move(*stage), std::move(*items)));
  }
  void show(const ClayView& clay) { stage_->clay().show(clay); }

  /// `coat`: null where the second frame of a pair is as plain as the first. `drag`: of its window,
  /// rad a frame.
  DecoratedFrames compare(const view::PotView& plain, const view::PotView& decorated,
                          const decoration::CoatPicture* coat, double drag, int pairs) {
    std::array<std::vector<double>, 2> ms;
    for (int n = -kFirst; n < pairs; ++n)
      for (const std::size_t which : {0u, 1u}) {
        frame_.pot = which == 0 ? plain : decorated;
        frame_.pot->camera = camera_;
        frame_.pot->wheel = false;
        frame_.pot->clay_angle = kTurn * n;
        if (which == 1) frame_.pot->window += drag * n;
        stage_->coat().show(which == 0 ? nullptr : coat);
        const double from = files::monotonic_seconds();
        canvas_[which].paint({*stage_, *items_, pictures_}, frame_, {.samples = 0},
                             kScaleWithoutGpu, render::Canvas::Onto::own);
        glFinish();
        if (n >= 0) ms[which].push_back(1e3 * (files::monotonic_seconds() - from));
      }
    stage_->coat().show(nullptr);
    return {frame_.width, frame_.height, "", "", pairs, middle(ms[0]), middle(ms[1])};
  }

 private:
  Studio(std::pair<int, int> size, std::unique_ptr<render::Renderer> renderer,
         std::unique_ptr<render::Stage> stage, std::unique_ptr<render::ItemPainter> items)
      : renderer_(std::move(renderer)), stage_(std::move(stage)), items_(std::move(items)) {
    frame_.width = size.first;
    frame_.height = size.second;
    const auto w = static_cast<float>(size.first), h = static_cast<float>(size.second);
    camera_ = view::frame_pot(size.first, size.second, {0.25f * w, 0.12f * h, 0.5f * w, 0.7f * h},
                              kPotTall, kWidest);
  }

  std::unique_ptr<render::Renderer> renderer_;  // has the context that the others live in
  std::unique_ptr<render::Stage> stage_;
  std::unique_ptr<render::ItemPainter> items_;
  render::ItemPainter::Pictures pictures_;
  std::array<render::Canvas, 2> canvas_;
  view::Frame frame_;
  view::Camera camera_;
};

}  // namespace

Result<std::vector<DecoratedFrames>> measure_decorated(const std::filesystem::path& config,
                                                       std::pair<int, int> size, int pairs) {
  const settings::ExhibitRead exhibit = settings::read_exhibit(config);
  std::vector<DecoratedFrames> rows;
  if (!exhibit.exhibit.decorate || !exhibit.exhibit.ways) return rows;
  const auto ways = exhibit::read_ways(*exhibit.exhibit.ways).ways;
  auto studio = Studio::open(size);
  if (!studio) return tl::unexpected(studio.error());
  const ClayView clay = jar();
  (*studio)->show(clay);
  view::PotView dry, fired;
  fired.finish = view::Finish::fired;
  const auto add = [&](const char* way, const char* state, DecoratedFrames row) {
    row.way = way;
    row.state = state;
    rows.push_back(std::move(row));
  };
  for (const char* id : kMeasuredWays) {
    const auto way = ways.find(id);
    if (way == ways.end()) continue;
    const auto pot = decorating::DecoratedPot::begin(clay.profile(), way->second);
    if (!pot) return tl::unexpected(pot.error());
    use_every_tool(**pot);
    const auto compare = [&](const char* state, const view::PotView& plain,
                             const view::PotView& decorated) {
      add(id, state, (*studio)->compare(plain, decorated, &(*pot)->picture(), 0.0, pairs));
    };
    compare("dry", dry, dry);
    view::PotView wet = dry;
    wet.slip_wet = true;
    wet.wetness_by_row.assign(96, 1.0f);
    compare("wet slip", dry, wet);
    view::PotView firing = dry;
    firing.finish = view::Finish::firing;
    firing.firing = {std::nullopt, 0.5, 0.5};
    compare("firing", firing, firing);
    (*pot)->fire(true);
    (*pot)->finish();
    compare("fired", fired, fired);
  }
  add("light", "fired", (*studio)->compare(fired, fired, nullptr, 0.02, pairs));
  return rows;
}

files::Json json_of(const DecoratedFrames& row) {
  return files::Json::object(
      {{"size", std::to_string(row.width) + "x" + std::to_string(row.height)},
       {"way", row.way},
       {"state", row.state},
       {"pairs", row.pairs},
       {"plain_ms", row.plain_ms},
       {"decorated_ms", row.decorated_ms}});
}

std::string text_of(const std::vector<DecoratedFrames>& rows) {
  if (rows.empty()) return "";
  std::string text = "A decorated pot's frame over a plain one's, at half scale:\n";
  char line[160];
  std::snprintf(line, sizeof line, "%-11s%-14s%-10s%10s%14s%8s\n", "size", "way", "pot", "plain ms",
                "decorated ms", "over");
  text += line;
  for (const DecoratedFrames& row : rows) {
    const std::string size = std::to_string(row.width) + "x" + std::to_string(row.height);
    std::snprintf(line, sizeof line, "%-11s%-14s%-10s%10.1f%14.1f%+7.0f%%\n", size.c_str(),
                  row.way.c_str(), row.state.c_str(), row.plain_ms, row.decorated_ms,
                  100 * row.over());
    text += line;
  }
  return text;
}

}  // namespace onggi::measure
