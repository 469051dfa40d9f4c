#include "kiosk/lab/measure/frame_load.h"

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/exhibit/rehearsal/scripted_visitor.h"
#include "kiosk/lab/measure/measurement_folder.h"

namespace onggi::measure {
namespace {

constexpr int kTicks = 16;          // of 1 ms, a frame
constexpr double kToWheel = 120.0;  // s of visit

Problem shut() { return {"the window", "It was closed.", "Leave it open.", 1}; }

/// An exhibit in which every frame is 16 ms of its time.
class Counted {
 public:
  explicit Counted(exhibit::Kiosk& kiosk) : kiosk_(kiosk) {}

  Result<void> frame(bool draw, rehearsal::ScriptedVisitor* visitor, int ticks = kTicks) {
    kiosk_.advance(ticks);
    if (!kiosk_.frame(now_, draw)) return tl::unexpected(shut());
    now_ += kTicks * 1e-3;
    if (visitor == nullptr) return {};
    return visitor->step(now_);
  }
  Result<void> frames(double seconds, rehearsal::ScriptedVisitor* visitor) {
    for (const double end = now_ + seconds; now_ < end;)
      if (auto good = frame(false, visitor); !good) return good;
    return {};
  }
  /// Draws `count` frames, after a few to settle.
  Result<FrameLoad> count(const char* screen, bool moving, int count,
                          rehearsal::ScriptedVisitor* visitor) {
    render::Renderer& renderer = kiosk_.renderer();
    const int ticks = moving ? kTicks : 0;
    for (int n = 0; n < 4; ++n)
      if (auto good = frame(true, visitor, ticks); !good) return tl::unexpected(good.error());
    FrameLoad load{renderer.width(), renderer.height(), screen, moving, count};
    load.shading_counted = renderer.status().shading_counted;
    renderer.count_shading(true);
    const render::FrameWork before = renderer.status().work;
    for (int n = 0; n < count; ++n)
      if (auto good = frame(true, visitor, ticks); !good) return tl::unexpected(good.error());
    load.work = renderer.status().work - before;
    renderer.count_shading(false);
    return load;
  }
  double now() const { return now_; }

 private:
  exhibit::Kiosk& kiosk_;
  double now_ = 0;
};

}  // namespace

Result<std::vector<FrameLoad>> measure_load(const FrameLoadPlan& plan) {
  const auto nowhere = MeasurementFolder::make();
  if (!nowhere) return tl::unexpected(nowhere.error());
  exhibit::KioskOptions options;
  options.config = plan.config;
  options.keepsakes = nowhere->path();
  options.window.width = plan.size.first;
  options.window.height = plan.size.second;
  options.devices = false;
  options.stepped = true;
  auto kiosk = exhibit::Kiosk::open(options);
  if (!kiosk) return tl::unexpected(kiosk.error());
  Counted counted(**kiosk);
  std::vector<FrameLoad> loads;
  const auto count = [&](const char* screen, rehearsal::ScriptedVisitor* visitor) -> Result<void> {
    for (const bool moving : {true, false}) {
      auto load = counted.count(screen, moving, plan.frames, moving ? visitor : nullptr);
      if (!load) return tl::unexpected(load.error());
      loads.push_back(*load);
    }
    return {};
  };
  if (auto good = counted.frames(plan.attract, nullptr); !good) return tl::unexpected(good.error());
  if (auto good = count("attract", nullptr); !good) return tl::unexpected(good.error());

  rehearsal::ScriptedVisitor::Plan visit;
  visit.naive = rehearsal::ScriptedVisitor::Naive{600, rehearsal::NaiveHands::Pointer::mouse};
  visit.linger = 0.5;
  rehearsal::ScriptedVisitor visitor(**kiosk, visit, {});
  const double asked = counted.now();
  while (!visitor.throwing()) {
    if (auto good = counted.frame(false, &visitor); !good) return tl::unexpected(good.error());
    if (counted.now() - asked > kToWheel)
      return problem("the exhibit", "Its wheel was not reached within two minutes.",
                     "Read its log.", 1);
  }
  if (auto good = counted.frames(plan.naive, &visitor); !good) return tl::unexpected(good.error());
  if (auto good = count("throwing", &visitor); !good) return tl::unexpected(good.error());
  return loads;
}

files::Json json_of(const FrameLoad& load) {
  const render::FrameWork& work = load.work;
  files::Json one =
      files::Json::object({{"size", std::to_string(load.width) + "x" + std::to_string(load.height)},
                           {"screen", load.screen},
                           {"moving", load.moving},
                           {"frames", load.frames},
                           {"draw_calls", load.a_frame(work.draws)},
                           {"vertices", load.a_frame(work.vertices)},
                           {"bytes", load.a_frame(work.bytes)},
                           {"switches", load.a_frame(work.switches)},
                           {"copied_pixels", load.a_frame(work.copied)}});
  if (!load.shading_counted) return one;
  one["vertex_runs"] = load.a_frame(work.vertex_runs);
  one["fragment_runs"] = load.a_frame(work.fragment_runs);
  return one;
}

std::string text_of(const std::vector<FrameLoad>& loads) {
  std::string text = "A frame as a GPU draws it asks for:\n";
  char line[200];
  std::snprintf(line, sizeof line, "%-11s%-10s%-8s%7s%10s%9s%10s%9s%9s%11s\n", "size", "screen", "",
                "draws", "vertices", "bytes", "switches", "copied", "v. runs", "f. runs");
  text += line;
  for (const FrameLoad& load : loads) {
    const std::string size = std::to_string(load.width) + "x" + std::to_string(load.height);
    const auto each = [&load](std::uint64_t count) { return load.a_frame(count); };
    std::snprintf(line, sizeof line, "%-11s%-10s%-8s%7.1f%10.0f%9.0f%10.1f%9.0f", size.c_str(),
                  load.screen.c_str(), load.moving ? "moving" : "still", each(load.work.draws),
                  each(load.work.vertices), each(load.work.bytes), each(load.work.switches),
                  each(load.work.copied));
    text += line;
    if (load.shading_counted)
      std::snprintf(line, sizeof line, "%9.0f%11.0f\n", each(load.work.vertex_runs),
                    each(load.work.fragment_runs));
    else
      std::snprintf(line, sizeof line, "%20s\n", "not counted here");
    text += line;
  }
  return text;
}

}  // namespace onggi::measure
