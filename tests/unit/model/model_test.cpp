#include <gtest/gtest.h>

#include <set>
#include <type_traits>

#include "core/model/channel.h"
#include "core/model/operator_input.h"
#include "core/model/override_command.h"
#include "core/model/sample_block.h"
#include "core/model/snapshot.h"
#include "core/model/verdict.h"

namespace stillcut {
namespace {

// Values that cross a thread are plain: copied by memory, without a constructor that could allocate.
static_assert(std::is_trivially_copyable_v<Verdict>);
static_assert(std::is_trivially_copyable_v<OverrideRequest>);
static_assert(std::is_trivially_copyable_v<OverrideCommand>);
static_assert(std::is_trivially_copyable_v<MachineState>);
static_assert(std::is_trivially_copyable_v<Event>);
static_assert(std::is_trivially_copyable_v<Snapshot>);
// One door to the machine: nobody but the gate makes a command.
static_assert(!std::is_default_constructible_v<OverrideCommand>);
static_assert(!std::is_constructible_v<OverrideCommand, CommandRecord>);

TEST(Channel, EveryQuantityHasANameThatReadsBackAndAUnit) {
  std::set<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(SensorQuantity::SpindleSpeed); ++i) {
    const auto quantity = static_cast<SensorQuantity>(i);
    EXPECT_TRUE(names.insert(name(quantity)).second);
    ASSERT_TRUE(sensorQuantityFromName(name(quantity)).has_value());
    EXPECT_EQ(*sensorQuantityFromName(name(quantity)), quantity);
    EXPECT_FALSE(siUnit(quantity).empty());
  }
  EXPECT_FALSE(sensorQuantityFromName("accelaration").has_value());
  EXPECT_FALSE(sensorQuantityFromName("").has_value());
}

// Caliskan 2018 eq. 28.
TEST(Channel, IntegrationFactorTakesEachQuantityToVelocity) {
  EXPECT_EQ(integrationFactor(SensorQuantity::Acceleration), -1);
  EXPECT_EQ(integrationFactor(SensorQuantity::Velocity), 0);
  EXPECT_EQ(integrationFactor(SensorQuantity::Displacement), 1);
  EXPECT_EQ(integrationFactor(SensorQuantity::Sound), 0);
}

TEST(SampleBlock, ChannelsLieOneAfterTheOther) {
  SampleBlock block;
  block.allocate(3, 100);
  block.frames = 10;
  for (int c = 0; c < 3; ++c) {
    for (float& v : block.channel(c)) v = static_cast<float>(c + 1);
  }
  const SampleBlock& read = block;
  EXPECT_EQ(read.channel(1).size(), 10u);
  EXPECT_EQ(read.samples[0], 1.0F);
  EXPECT_EQ(read.samples[10], 0.0F) << "frames not filled are not part of the channel";
  EXPECT_EQ(read.samples[100], 2.0F);
  EXPECT_EQ(read.samples[209], 3.0F);
}

TEST(SampleBlock, EndsOneFrameAfterItsLastSample) {
  SampleBlock block;
  block.allocate(1, 256);
  block.frames = 256;
  block.rate = Hertz(25600.0);
  block.firstSample = instantFromNs(1'000'000'000);
  EXPECT_EQ(toNs(block.end()), 1'010'000'000);
}

TEST(SampleBlock, FlagsAreIndependent) {
  SampleBlock block;
  block.flags = kBlockGap | kBlockEnd;
  EXPECT_TRUE(block.has(kBlockGap));
  EXPECT_FALSE(block.has(kBlockClipped));
  EXPECT_TRUE(block.has(kBlockEnd));
}

TEST(Verdict, OnlyAValidOnsetOrChatterAlarms) {
  Verdict verdict;
  for (const CutState state : {CutState::AirCutting, CutState::Stable, CutState::Onset, CutState::Chatter}) {
    verdict.state = state;
    verdict.valid = false;
    EXPECT_FALSE(verdict.alarming()) << name(state);
    verdict.valid = true;
    EXPECT_EQ(verdict.alarming(), state == CutState::Onset || state == CutState::Chatter) << name(state);
  }
}

TEST(Names, AreThoseOfTheEventsFile) {
  EXPECT_EQ(name(CutState::Onset), "onset");
  EXPECT_EQ(name(CutPhase::RunUp), "runup");
  EXPECT_EQ(name(ChatterKind::Hopf), "hopf");
  EXPECT_EQ(name(Authority::Advise), "advise");
}

TEST(Authority, StartsOff) {
  EXPECT_EQ(Snapshot{}.authority, Authority::Off);
  EXPECT_EQ(OperatorInput{}.authority, Authority::Off);
  EXPECT_FALSE(Snapshot{}.autoAllowed);
}

TEST(MachineState, TargetIsProgrammedTimesOverride) {
  MachineState state;
  state.programmedSpeed = Rpm(8800.0);
  state.speedOverride = Ratio(0.97);
  EXPECT_DOUBLE_EQ(state.targetSpeed().value, 8536.0);
  EXPECT_FALSE(state.valid) << "nothing was read yet";
}

}  // namespace
}  // namespace stillcut
