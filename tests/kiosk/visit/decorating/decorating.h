#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "kiosk/visit/decorating/decorated_pot.h"
#include "tests/kiosk/visit/decorating/every_tool.h"

namespace onggi::decorating {

/// A jar, and a way that has every tool.
struct Decorating : testing::Test {
  decoration::Way way = every_tool();
  std::unique_ptr<DecoratedPot> pot = *DecoratedPot::begin(a_jar(), way);

  void touch(int tool, double along, double turns = 0.3) {
    pot->choose_tool(tool);
    pot->press({along, turns});
    pot->lift();
    pot->finish();
  }
  int slip(double along, double turns) const {
    return pot->surface()
        .slip(static_cast<int>(along * 4000), static_cast<int>(turns * surface::kSectors))
        .thickness();
  }
  decoration::CoatPicture::Texel texel(double along, double turns) const {
    return pot->picture().paint()[static_cast<std::size_t>(along * 4000) * surface::kSectors +
                                  static_cast<std::size_t>(turns * surface::kSectors)];
  }
  /// The picture that a fresh look at the surface gives.
  void expect_whole_picture() {
    pot->finish();
    decoration::CoatPicture whole(pot->surface(), way.palette);
    whole.touch_all();
    whole.draw(pot->surface(), 1 << 20);
    EXPECT_TRUE(whole.paint() == pot->picture().paint());
    EXPECT_TRUE(whole.form() == pot->picture().form());
  }
};

}  // namespace onggi::decorating
