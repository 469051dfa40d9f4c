#include "kiosk/lab/measure/touch_to_sound.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "engine/math/random.h"
#include "engine/scene/scene.h"
#include "kiosk/exhibit/tuning/machine.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/visit/sound/ear.h"
#include "kiosk/visit/sound/speaker.h"
#include "kiosk/wheel/loop/loop_thread.h"

namespace onggi::measure {

namespace {

constexpr double kGoal = 20.0;  // ms, p99
// Soft clay loses a light finger for some ticks, so a touch begins only after this long without
// contact.
constexpr std::int64_t kApart = 2'000'000'000LL * sound::Speaker::kBlock / 48000;  // ns

/// A finger beside the wall, half a millimetre into it or 10 mm off it.
HandInput finger(const SceneDef& def, bool on) {
  HandInput hand;
  hand.position = {def.clay.outer_radius + def.tool.radius + (on ? -0.0005 : 0.01),
                   0.5 * def.clay.height, 0.0};
  hand.active = true;
  return hand;
}

bool rubs(const loop::LoopStatus& status) {
  return status.feedback.hand[0].contact && length(status.feedback.hand[0].touch.push) > 0.0;
}

/// Follows each touch from the tick that feels it to the block with its sound.
class Touches {
 public:
  void look(const loop::LoopStatus& now, const sound::Speaker::Status& speaker) {
    const bool rub = rubs(now);
    if (rub && now.at_ns - rubbed_ns_ > kApart) {
      if (felt_ns_ != 0) ++unheard_;
      felt_ns_ = now.at_ns;
    }
    if (rub) rubbed_ns_ = now.at_ns;
    if (speaker.touches == counted_) return;
    counted_ = speaker.touches;
    if (felt_ns_ == 0) return;
    delays_.push_back(static_cast<double>(speaker.touched_ns - felt_ns_) * 1e-6);
    felt_ns_ = 0;
  }
  void tell(TouchToSound& out) {
    out.touches = static_cast<int>(delays_.size());
    out.unheard = unheard_;
    if (delays_.empty()) return;
    std::sort(delays_.begin(), delays_.end());
    const auto rank = [&](double share) {
      return delays_[std::min(
          delays_.size() - 1,
          static_cast<std::size_t>(share * static_cast<double>(delays_.size())))];
    };
    out.median_ms = rank(0.5);
    out.p99_ms = rank(0.99);
    out.worst_ms = delays_.back();
  }

 private:
  std::int64_t rubbed_ns_ = 0, felt_ns_ = 0;
  std::uint64_t counted_ = 0;
  int unheard_ = 0;
  std::vector<double> delays_;
};

}  // namespace

Result<TouchToSound> touch_to_sound(const TouchToSoundPlan& plan, std::FILE* progress) {
  auto scene = Scene::create(plan.scene);
  if (!scene) return tl::unexpected(scene.error());
  loop::LoopThread loop;
  sound::Speaker speaker([&loop] { return sound::hear(loop.status()); });
  TouchToSound out;
  out.machine = tuning::machine_name();
  out.card = speaker.remark();
  out.seed = plan.seed;
  if (!speaker.playing())
    return problem("sound", out.card, "Plug a sound card in, or try SDL_AUDIODRIVER=dummy.");
  speaker.volume(0.5);
  loop.start(std::make_unique<Scene>(std::move(*scene)));
  loop.wheel(18.0);
  Random chance(plan.seed);
  Touches touches;
  const double begun = files::monotonic_seconds();
  double change = begun + 1.0, collect = begun, said = begun;
  bool on = false;
  for (double now = begun; now - begun < plan.seconds; now = files::monotonic_seconds()) {
    if (now >= change) {
      on = !on;
      change = now + chance.uniform(0.05, 0.15);
      loop.hand(0, finger(plan.scene, on));
    }
    if (now >= collect) {
      loop.collect();
      collect = now + 0.016;
    }
    touches.look(loop.status(), speaker.status());
    if (now - said >= 2.0) {
      std::fprintf(progress, "\r%3.0f %%, %.0f s left", 100.0 * (now - begun) / plan.seconds,
                   plan.seconds - (now - begun));
      std::fflush(progress);
      said = now;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  if (said > begun) std::fprintf(progress, "\r%40s\r", "");
  touches.tell(out);
  out.seconds = files::monotonic_seconds() - begun;
  const auto status = speaker.status();
  out.blocks = status.blocks;
  out.dry = status.late;
  out.worst_gap_ms = 1e3 * status.worst_gap_s;
  out.late_ticks = loop.status().deadlines.late;
  return out;
}

files::Json json_of(const TouchToSound& heard) {
  using files::Json;
  return Json::object({{"machine", heard.machine},
                       {"card", heard.card},
                       {"seed", heard.seed},
                       {"seconds", heard.seconds},
                       {"touches", heard.touches},
                       {"unheard", heard.unheard},
                       {"touch_ms_median", heard.median_ms},
                       {"touch_ms_p99", heard.p99_ms},
                       {"touch_ms_worst", heard.worst_ms},
                       {"blocks", heard.blocks},
                       {"ran_dry", heard.dry},
                       {"worst_gap_ms", heard.worst_gap_ms},
                       {"late_ticks", heard.late_ticks}});
}

std::string text_of(const TouchToSound& heard) {
  char text[640];
  std::snprintf(
      text, sizeof text,
      "%s. %s\n"
      "%d touches in %.0f s: heard after %.1f ms (median), %.1f ms (99 of 100; goal %.0f), "
      "%.1f ms (worst); %d too short to be heard.\n"
      "%llu blocks of %.0f ms; the card ran dry %llu times, the longest wait was %.1f ms.\n",
      heard.machine.c_str(), heard.card.c_str(), heard.touches, heard.seconds, heard.median_ms,
      heard.p99_ms, kGoal, heard.worst_ms, heard.unheard,
      static_cast<unsigned long long>(heard.blocks), 1e3 * sound::Speaker::kBlock / sound::kRate,
      static_cast<unsigned long long>(heard.dry), heard.worst_gap_ms);
  return text;
}

}  // namespace onggi::measure
