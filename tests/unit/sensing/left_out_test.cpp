// A bad channel is left out, the others go on.
#include "core/sensing/left_out.h"

#include <gtest/gtest.h>

namespace stillcut::detect {
namespace {

constexpr Reason kDead{ReasonCode::InputDead, {0.0}};
constexpr Seconds kBlock(0.1);

LeftOut of(std::initializer_list<SensorQuantity> quantities) {
  CutSetup setup;
  for (const SensorQuantity q : quantities) {
    setup.channels.emplace_back();
    setup.channels.back().quantity = q;
  }
  LeftOut out;
  out.prepare(setup);
  return out;
}

TEST(LeftOut, ABadChannelGoesAtOnceAndComesBackAfterASecondWithoutAFault) {
  LeftOut out = of({SensorQuantity::Sound, SensorQuantity::Sound});
  out.see(0, kDead, kBlock);
  EXPECT_TRUE(out.is(0));
  EXPECT_FALSE(out.is(1));
  EXPECT_EQ(out.allOut().code, ReasonCode::None);
  for (int i = 0; i < 9; ++i) out.see(0, {}, kBlock);
  EXPECT_TRUE(out.is(0));
  EXPECT_FALSE(out.takeReturned());
  out.see(0, kDead, kBlock);
  for (int i = 0; i < 11; ++i) out.see(0, {}, kBlock);
  EXPECT_FALSE(out.is(0));
  EXPECT_TRUE(out.takeReturned());
  EXPECT_FALSE(out.takeReturned()) << "said once";
}

TEST(LeftOut, WhereNoneIsLeftTheFirstFaultIsTheReasonAndTheFirstSoundOneIsBackAtOnce) {
  LeftOut out = of({SensorQuantity::Sound, SensorQuantity::Sound, SensorQuantity::SpindleSpeed});
  out.see(1, {ReasonCode::InputHum, {1.0, 50.0}}, kBlock);
  out.see(0, kDead, kBlock);
  EXPECT_EQ(out.allOut().code, ReasonCode::InputDead) << "a speed tells nothing of the cut";
  out.see(1, {}, kBlock);
  EXPECT_FALSE(out.is(1));
  EXPECT_TRUE(out.is(0));
  EXPECT_EQ(out.allOut().code, ReasonCode::None);
}

}  // namespace
}  // namespace stillcut::detect
