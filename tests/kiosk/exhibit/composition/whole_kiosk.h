#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <thread>

#include "tests/kiosk/exhibit/composition/one_jar.h"

namespace onggi::exhibit {

/// A stepped kiosk with the moon jar on its shelf, where pots are kept as they are thrown.
class WholeKiosk : public OneJar {
 protected:
  void SetUp() override {
    KioskOptions options;
    options.window = {.width = 640, .height = 360, .visible = false, .title = "Onggi tests"};
    options.stepped = true;
    change(options);
    open(scene_, keepsake_, options, before_);
  }
  /// What a test wants of it.
  virtual void change(KioskOptions&) {}
  void frame() {
    kiosk_->advance(2);  // Nobody throws.
    // Shelf, saves and pictures have threads of their own. While they work, the kiosk's time goes
    // no faster than theirs: else a visitor who waits for a save on a busy machine has long been
    // idle.
    const bool waits =
        kiosk_->doing().turning || kiosk_->doing().saving || !kiosk_->shelf().complete();
    if (waits) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    kiosk_->frame(now_ += waits ? 0.002 : 0.04, false);
  }
  template <class Done>
  void until(const Done& done) {
    for (int n = 0; n < 20'000 && !done(); ++n) frame();
    ASSERT_TRUE(done());
  }
  void press(const std::string& control) {
    SCOPED_TRACE(control);
    until([&] { return kiosk_->visit().control(control).has_value(); });
    kiosk_->visit().activate(control, now_);
    frame();
  }
  /// A finger on the pot for three seconds, so that there is a pot to call done.
  void touch_clay(bool left_handed) {
    view::InputEvent finger{.kind = view::InputEvent::Kind::pointer_down,
                            .x = left_handed ? 640.0F / 3 : 1280.0F / 3,
                            .y = 216.0F,
                            .glass = true};
    kiosk_->visit().input(finger, now_);
    int contacts = 0;
    for (int n = 0; n < 75; ++n) {
      kiosk_->advance(40);  // the clay's time goes as fast as the visitor's
      kiosk_->frame(now_ += 0.04, false);
      contacts += kiosk_->wheel_host().status().feedback.hand[0].contact ? 1 : 0;
    }
    ASSERT_GT(contacts, 0);
    finger.kind = view::InputEvent::Kind::pointer_up;
    kiosk_->visit().input(finger, now_);
    frame();
  }
  /// From attract to a pot whose keepsake is on its way, by a hand of its choice. `last`: what is
  /// done before the frame that makes the keepsake.
  void ask_to_keep_a_pot(
      bool left_handed, const std::function<void()>& last = [] {}) {
    press("attract.begin");
    if (left_handed) {
      press("comfort");
      press("comfort.left_handed");
      press("comfort.close");
    }
    press("choose.card.0");
    press("choose.throw");
    until([&] { return kiosk_->visit().sight().has_value(); });
    for (int n = 0; n < 100; ++n) frame();  // Four seconds: a shorter visit is counted apart.
    touch_clay(left_handed);
    press("throw.done");
    until([&] { return kiosk_->visit().control("result.keep").has_value(); });
    last();
    press("result.keep");
  }
  void keep_a_pot(bool left_handed) {
    ask_to_keep_a_pot(left_handed);
    until([&] { return kiosk_->doing().kept && kiosk_->doing().kept->saved; });
  }

  std::string keepsake_;         ///< More of its table,
  std::string before_;           ///< and what stands before it.
  std::string scene_ = "paper";  ///< Of config/scenes.
};

/// Without pictures that turn, which take some seconds.
class StillKiosk : public WholeKiosk {
 protected:
  StillKiosk() { keepsake_ = "turning = false\n"; }
};

}  // namespace onggi::exhibit
