// What may be wired together, what kind of failure a set-up says, and that a recording that stopped is said at the end.

#include "app/compose/rig.h"

#include <gtest/gtest.h>

#include "tests/support/scripted_parts.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

// A device that delivers nothing.
class SilentDevice final : public daq::DaqSource {
 public:
  explicit SilentDevice(bool live, bool opens = true) : live_(live), opens_(opens) {}
  Result<daq::SourceFormat> open() override {
    if (!opens_) return Error{message("device"), message("is not there")};
    return test::format();
  }
  bool read(SampleBlock& /*block*/) noexcept override { return false; }
  void stop() noexcept override {}
  Message fault() const override { return {}; }
  bool live() const override { return live_; }

 private:
  bool live_, opens_;
};

class FakeMachine final : public cnc::CncLink {
 public:
  explicit FakeMachine(bool simulated, bool opens = true, int* openings = nullptr)
      : simulated_(simulated), opens_(opens), openings_(openings) {}
  cnc::LinkInfo describe() const override { return {.id = "fake", .label = "Fake", .simulated = simulated_}; }
  Status open() override {
    if (openings_ != nullptr) ++*openings_;
    return opens_ ? Status(Done{}) : Status(Error{message("machine"), message("does not answer")});
  }
  MachineState read(Instant /*now*/) noexcept override { return {}; }
  void apply(const OverrideCommand& /*command*/, Instant /*now*/) noexcept override {}
  void release(Instant /*now*/) noexcept override {}

 private:
  bool simulated_, opens_;
  int* openings_;
};

RigSpec specOf(std::unique_ptr<daq::DaqSource> device, std::unique_ptr<cnc::CncLink> link) {
  RigSpec spec;
  spec.device = std::move(device);
  spec.link = std::move(link);
  spec.setup = test::setup();
  spec.methods.strategy = "monitor";
  return spec;
}

TEST(Rig, RefusesARealMachineToASourceThatIsNotLive) {
  int openings = 0;
  SetUpFault fault = SetUpFault::Hardware;
  const auto refused = Rig::build(
      specOf(std::make_unique<SilentDevice>(false), std::make_unique<FakeMachine>(false, true, &openings)), &fault);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(fault, SetUpFault::Input);
  EXPECT_EQ(openings, 0) << "the machine is not even spoken to";
  EXPECT_NE(refused.error().line().find("'fake'"), std::string::npos) << refused.error().line();

  const auto simulated = Rig::build(specOf(std::make_unique<SilentDevice>(false), std::make_unique<FakeMachine>(true)));
  EXPECT_TRUE(simulated.ok()) << simulated.error().line();
  const auto live = Rig::build(specOf(std::make_unique<SilentDevice>(true), std::make_unique<FakeMachine>(false)));
  EXPECT_TRUE(live.ok()) << live.error().line();
}

TEST(Rig, TellsHardwareThatFailsFromInputThatIsWrong) {
  SetUpFault fault = SetUpFault::Input;
  EXPECT_FALSE(Rig::build(specOf(std::make_unique<SilentDevice>(true, false), nullptr), &fault).ok());
  EXPECT_EQ(fault, SetUpFault::Hardware);
  fault = SetUpFault::Input;
  EXPECT_FALSE(
      Rig::build(specOf(std::make_unique<SilentDevice>(true), std::make_unique<FakeMachine>(false, false)), &fault)
          .ok());
  EXPECT_EQ(fault, SetUpFault::Hardware);

  RigSpec unknown = specOf(std::make_unique<SilentDevice>(true), nullptr);
  unknown.methods.strategy = "nonsense";
  EXPECT_FALSE(Rig::build(std::move(unknown), &fault).ok());
  EXPECT_EQ(fault, SetUpFault::Input);
}

TEST(Rig, StopClosesTheRecording) {
  const record::TempFolder folder;
  auto rig = Rig::build(specOf(std::make_unique<SilentDevice>(true), nullptr));
  ASSERT_TRUE(rig.ok()) << rig.error().line();
  ASSERT_TRUE((*rig)->recordTo(folder / "run.h5", "").ok());
  (*rig)->start({});
  const Status stopped = (*rig)->stop();
  EXPECT_TRUE(stopped.ok()) << stopped.error().line();
  EXPECT_FALSE((*rig)->recorder()->status().recording);
}

}  // namespace
}  // namespace stillcut::app
