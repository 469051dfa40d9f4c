#include "kiosk/picture/render/clay_skin.h"

#include <algorithm>
#include <string>

namespace onggi::render {
namespace {

constexpr std::size_t kMostRows = 256;

// Display colours of LOOK.md, as linear light.
const glm::vec3 kDryColor(0.405f, 0.240f, 0.137f), kWetColor(0.1559f, 0.0704f, 0.0423f);

glm::vec3 vec(const content::LinearColor& c) { return {c[0], c[1], c[2]}; }

void set_glaze(const Program& program, const std::string& name, const view::Glazing& glazing) {
  const content::GlazeLook& look = glazing.look;
  program.set((name + ".body").c_str(), vec(look.body));
  program.set((name + ".glass").c_str(), vec(look.glass));
  program.set((name + ".slip").c_str(), vec(look.slip));
  program.set((name + ".band").c_str(), vec(look.band));
  program.set((name + ".lie").c_str(),
              glm::vec4(look.slip_cover, look.brushed, look.pooling, look.gloss));
  program.set((name + ".band_at").c_str(),
              glm::vec3(look.band_height, look.band_width,
                        static_cast<float>(std::clamp(glazing.coat, 0.0, 4.0))));
}

}  // namespace

std::size_t ClaySkin::of(const view::PotView& pot) {
  if (pot.finish == view::Finish::fired) return kGlazed;
  if (pot.finish == view::Finish::firing) return kFiring;
  if (pot.wetness_by_row.empty()) return pot.wetness > 0.0 ? kWet : kDry;
  const bool wet = std::any_of(pot.wetness_by_row.begin(), pot.wetness_by_row.end(),
                               [](float w) { return w > 0.0f; });
  return wet ? kWet : kDry;
}

void ClaySkin::prepare(const view::PotView& pot) {
  if (of(pot) != kWet) return;
  std::vector<float> wet = pot.wetness_by_row;
  if (wet.empty()) wet.push_back(static_cast<float>(pot.wetness));
  wet.resize(std::min(wet.size(), kMostRows));
  if (wet == wet_) return;
  const auto count = static_cast<int>(wet.size());
  if (rows_.width != count) {
    rows_ = Texture::create(GL_R32F, count, 1, GL_RED, GL_FLOAT, wet.data());
  } else {
    calls::bind_texture(rows_.name.get());
    calls::texture_part(0, 0, count, 1, GL_RED, GL_FLOAT, wet.data());
  }
  wet_ = std::move(wet);
}

void ClaySkin::set(const Program& program, const view::PotView& pot, int texture_unit) const {
  const std::size_t skin = of(pot);
  program.set("dry_color", kDryColor);
  program.set("wet_color", kWetColor);
  if (skin == kWet) {
    rows_.bind(texture_unit);
    program.set("wet_rows", texture_unit);
    program.set("wet_clay", pot.slip_wet ? 0.0f : 1.0f);
  }
  if (skin == kGlazed || skin == kFiring) set_glaze(program, "glaze", pot.glazing);
  if (skin != kFiring) return;
  set_glaze(program, "glaze_before", pot.firing.from.value_or(view::Glazing{}));
  program.set("from_clay", pot.firing.from ? 0.0f : 1.0f);
  program.set("fired", static_cast<float>(std::clamp(pot.firing.done, 0.0, 1.0)));
  program.set("glow", static_cast<float>(std::clamp(pot.firing.glow, 0.0, 1.0)));
}

}  // namespace onggi::render
