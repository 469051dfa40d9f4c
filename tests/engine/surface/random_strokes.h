#pragma once

#include <cstdlib>
#include <vector>

#include "engine/math/random.h"
#include "tests/engine/surface/decorated_pots.h"
#include "tests/support/sanitized.h"

namespace onggi::surface_test {

/// How many a test tries: 2e4, fewer under a sanitizer, or what ONGGI_STROKES says.
inline int random_strokes() {
  const char* said = std::getenv("ONGGI_STROKES");
  return said != nullptr ? std::atoi(said) : ONGGI_SANITIZED ? 4000 : 20'000;
}

/// Strokes of somebody who tries everything: any tool of any size, anywhere, most of them short.
class RandomStrokes {
 public:
  explicit RandomStrokes(std::uint64_t seed) : random_(seed) {}

  std::uint64_t bits() { return random_.bits(); }

  Stroke next(const Surface& surface) {
    // Dips and smoke touch every cell, so they are rare.
    const auto kind = static_cast<int>(random_.bits() % 2000);
    if (kind < 3) return {any_dip(), {}, random_.bits() % 4 == 0};
    if (kind < 4) return {any_smoke(), {}, random_.bits() % 4 == 0};
    return {any_tool(), any_way(surface), random_.bits() % 4 == 0};
  }

 private:
  template <class Def>
  Def any() {
    Def def;
    each_field<Def>([&](const auto& field) {
      using Value = std::remove_cvref_t<decltype(def.*(field.value))>;
      // Often small, at times at an end.
      const double part = random_.uniform() < 0.05 ? static_cast<double>(random_.bits() % 2)
                                                   : random_.uniform() * random_.uniform();
      const double value = field.least + part * (field.most - field.least);
      def.*(field.value) = static_cast<Value>(value);
    });
    return def;
  }

  Tool any_tool() {
    switch (random_.bits() % 9) {
      case 0:
        return any<CutDef>();
      case 1:
        return any<BrushDef>();
      case 2:
        return any<ScrapeDef>();
      case 3:
        return any<WipeDef>();
      case 4: {
        StampDef def = any<StampDef>();
        for (int n = 0; n < def.side * def.side; ++n)
          def.picture.push_back(static_cast<std::uint8_t>(random_.bits()));
        return def;
      }
      case 5:
        return any<ResistDef>();
      case 6:
        return any<FillDef>();
      case 7:
        return any<CoilDef>();
      default:
        return any<BurnishDef>();
    }
  }
  DipDef any_dip() {
    DipDef def = any<DipDef>();
    if (random_.bits() % 2 == 0) def.coat = DipDef::kGlaze;
    def.from = random_.uniform(0.0, 0.1);
    def.to = def.from + random_.uniform(0.001, 0.1);
    return def;
  }
  SmokeDef any_smoke() {
    SmokeDef def = any<SmokeDef>();
    def.from = random_.uniform(0.0, 0.15);
    return def;
  }

  std::vector<Station> any_way(const Surface& surface) {
    Tracer tracer(surface, random_.uniform(0.005, 0.2));
    const double end = surface.rows() * kRowHeight * 1e-6;
    HandPlace at{random_.uniform(-0.005, end + 0.005), random_.uniform(-3.0, 3.0)};
    for (auto n = random_.bits() % 4; n < 5; ++n) {
      at.pressure = random_.uniform(-0.2, 1.2);
      at.age = random_.uniform(-5.0, 100.0);
      tracer.go(at);
      at.along += random_.uniform(-0.002, 0.002);
      at.turns += random_.uniform(-0.01, 0.01);
    }
    tracer.lift();
    return tracer.stations();
  }

  Random random_;
};

}  // namespace onggi::surface_test
