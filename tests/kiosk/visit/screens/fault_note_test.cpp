#include "kiosk/visit/screens/fault_note.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::fault_note_test {
namespace {

TEST(FaultNote, WhatTheWheelPutRightIsToldInKindWordsForAWhileAndForgottenAtTheWheel) {
  struct Told {
    std::uint32_t bit;
    const char* en;
    const char* ko;
  };
  for (const Told& told : {Told{kFaultInput, "lost track of the hand", "손을 잠깐 놓쳤습니다"},
                           Told{kFaultTime, "paused for a moment", "물레가 잠깐 멈췄습니다"},
                           Told{kFaultForce, "force softer", "힘을 잠깐 줄였습니다"}})
    for (const bool korean : {false, true}) {
      Visitor v;
      if (korean) v.speak("ko");
      v.throw_a_pot();
      v.frames(1);
      const char* words = korean ? told.ko : told.en;
      EXPECT_EQ(words_in(v.frame).find(words), std::string::npos);
      EXPECT_EQ(v.wheel_commands.cleared, 0u);
      v.status.feedback.faults = told.bit;
      v.show();
      v.status.feedback.faults = 0;
      EXPECT_EQ(v.wheel_commands.cleared, told.bit);
      v.frames(4);
      EXPECT_NE(words_in(v.frame).find(words), std::string::npos) << words_in(v.frame);
      v.frames(4);
      EXPECT_EQ(words_in(v.frame).find(words), std::string::npos);
      EXPECT_EQ(v.visit->screen(), ScreenId::throwing);
    }
}

TEST(FaultNote, OfSeveralThatOneIsToldWhichTheHandFeelsAndAllAreForgotten) {
  Visitor v;
  v.throw_a_pot();
  v.status.feedback.faults = kFaultInput | kFaultTime | kFaultForce;
  v.show();
  EXPECT_NE(words_in(v.frame).find("force softer"), std::string::npos);
  EXPECT_EQ(v.wheel_commands.cleared, kFaultInput | kFaultTime | kFaultForce);
}

TEST(FaultNote, NobodyIsToldWhereNobodyIsAtTheWheelButTheWheelForgetsAllTheSame) {
  Visitor v;
  v.status.feedback.faults = kFaultForce;
  v.frames(1);
  EXPECT_EQ(words_in(v.frame).find("force softer"), std::string::npos);
  EXPECT_EQ(v.wheel_commands.cleared, std::uint32_t{kFaultForce});
}

}  // namespace
}  // namespace onggi::screens::fault_note_test
