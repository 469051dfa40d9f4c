#include "kiosk/exhibit/composition/keeping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "kiosk/keepsake/souvenir/open_passes.h"
#include "tests/kiosk/exhibit/composition/watched_renderer.h"
#include "tests/kiosk/exhibit/composition/whole_kiosk.h"

namespace onggi::exhibit::keeping_test {
namespace {

/// A stepped kiosk whose visitors get pages for their phones, and pictures for the gallery.
class PhoneKiosk : public WholeKiosk {
 protected:
  PhoneKiosk() { keepsake_ = "gallery = true\n[phone]\naddress = \"http://192.168.4.1:8080\"\n"; }
  void change(KioskOptions& options) override {
    options.renderer =
        [this](const render::WindowOptions& window) -> Result<std::unique_ptr<render::Renderer>> {
      auto real = render::Renderer::create(window);
      if (!real) return tl::unexpected(real.error());
      return std::make_unique<test::WatchedRenderer>(std::move(*real), watch_);
    };
    souvenir::OpenPasses(folder_ / "kept").serve();
  }
  test::Watch watch_;
};

// Guards `keeping_->draw_keepsake(...)`, and that draw_turning() knows of it. On a large grid one
// picture takes a third of a second; so do a postcard's words where they mix writings, and to show
// it takes half as long.
TEST_F(PhoneKiosk, AFrameDrawsOnePictureOfAKeepsakeOrShapesAPostcardsWordsOrShowsOne) {
  int drawn = 0, most = 0, all = 0;
  bool shown = false;
  watch_.called = [&](const char* call) {
    const std::string what = call;
    // Later ones are of the gallery.
    const bool shows =
        what == "make_picture" && !std::exchange(shown, what == "make_picture" || shown);
    drawn += what == "prepare_offscreen" || what == "draw_offscreen" || what == "read_skin" ||
                     what == "measure" || shows
                 ? 1
                 : 0;
  };
  const auto one_frame = [&] {
    most = std::max(most, drawn);
    all += drawn;
    drawn = 0;
    return kiosk_->doing().kept && kiosk_->doing().kept->turning;
  };
  ask_to_keep_a_pot(false, [&] {
    drawn = 0;
    shown = false;
  });
  until(one_frame);
  EXPECT_EQ(most, 1);
  EXPECT_EQ(all, 10 + TurntableRecorder::kPictures)
      << "two postcards, their room in two parts, the words of each, the first on the screen, one "
         "for the gallery, the "
         "plaster behind it, the model's colours, and those that turn";
  EXPECT_TRUE(kiosk_->doing().kept->saved->value().print.has_filename());
}

TEST_F(PhoneKiosk, AKeepsakeIsWholeThoughItsVisitorStartsAnewAtOnce) {
  ask_to_keep_a_pot(false);
  const auto made = kiosk_->doing().kept->state_hash;
  EXPECT_TRUE(kiosk_->doing().saving);
  kiosk_->visit().activate("keepsake.again", now_);
  press("choose.card.0");
  press("choose.throw");
  until([&] { return kiosk_->doing().kept->saved.has_value(); });
  EXPECT_EQ(kiosk_->doing().kept->state_hash, made);
  const auto& saved = *kiosk_->doing().kept->saved;
  ASSERT_TRUE(saved) << to_text(saved.error());
  for (const char* file : {"postcard.jpg", "print.jpg", "pot.glb", "small.jpg", "visit.onggi"})
    EXPECT_TRUE(std::filesystem::exists(saved->folder / file)) << file;
}

}  // namespace
}  // namespace onggi::exhibit::keeping_test
