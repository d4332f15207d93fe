// The numbers of a cut: angles of engagement, and that each kind of nonsense is refused by name.
#include "core/milling/cut_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

namespace stillcut::milling {
namespace {

constexpr double kPi = std::numbers::pi;

CutModel sound() {
  CutModel m;
  Mode mode;
  mode.frequency = Hertz(900.0);
  mode.damping = 0.02;
  mode.stiffness = 8e6;
  m.modes = {mode, mode};
  m.tool.teeth = 3;
  return m;
}

TEST(Engagement, SlotAndHalfImmersion) {
  for (MillingDirection side : {MillingDirection::Up, MillingDirection::Down}) {
    const Engagement slot{1.0, side};
    EXPECT_NEAR(slot.startAngle(), 0.0, 1e-12);
    EXPECT_NEAR(slot.exitAngle(), kPi, 1e-12);
  }
  EXPECT_NEAR((Engagement{0.5, MillingDirection::Up}.exitAngle()), kPi / 2.0, 1e-12);
  EXPECT_NEAR((Engagement{0.5, MillingDirection::Down}.startAngle()), kPi / 2.0, 1e-12);
}

// The width that a window of angles sweeps is the radial immersion: D/2 (cos phi_in - cos phi_out) = a.
TEST(Engagement, TheWindowSweepsTheWidthOfCut) {
  for (MillingDirection side : {MillingDirection::Up, MillingDirection::Down}) {
    for (int i = 1; i <= 100; ++i) {
      const Engagement e{0.01 * i, side};
      EXPECT_LE(0.0, e.startAngle());
      EXPECT_LT(e.startAngle(), e.exitAngle());
      EXPECT_LE(e.exitAngle(), kPi);
      EXPECT_NEAR(0.5 * (std::cos(e.startAngle()) - std::cos(e.exitAngle())), e.radialImmersion, 1e-12);
    }
  }
}

// Up and down are mirror images about the feed.
TEST(Engagement, UpAndDownMirror) {
  for (int i = 1; i <= 100; ++i) {
    const Engagement up{0.01 * i, MillingDirection::Up};
    const Engagement down{0.01 * i, MillingDirection::Down};
    EXPECT_NEAR(up.exitAngle(), kPi - down.startAngle(), 1e-12);
  }
}

TEST(Mode, MassIsStiffnessOverOmegaSquared) {
  Mode m;
  m.frequency = Hertz(922.0);
  m.stiffness = 1.34e6;
  const double omega = kTwoPi * 922.0;
  EXPECT_NEAR(m.mass() * omega * omega / m.stiffness, 1.0, 1e-14);
}

TEST(CutModelCheck, ASoundModelPasses) {
  EXPECT_TRUE(check(sound(), "a.toml").ok());
  CutModel pitched = sound();
  pitched.tool.pitch = {2.0, 2.1, kTwoPi - 4.1};
  pitched.tool.runout = {Metres(1e-6), Metres(0.0), Metres(-1e-6)};
  EXPECT_TRUE(check(pitched, "a.toml").ok());
}

TEST(CutModelCheck, EachKindOfNonsenseIsOneLineThatNamesItsPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  struct Case {
    const char* place;
    std::function<void(CutModel&)> spoil;
  };
  const Case cases[] = {{"mode", [](CutModel& m) { m.modes.clear(); }},
                        {"mode 1", [](CutModel& m) { m.modes[0].frequency = Hertz(0.0); }},
                        {"mode 2", [](CutModel& m) { m.modes[1].frequency = Hertz(-5.0); }},
                        {"mode 2", [=](CutModel& m) { m.modes[1].frequency = Hertz(infinite); }},
                        {"mode 1", [](CutModel& m) { m.modes[0].damping = 0.0; }},
                        {"mode 1", [](CutModel& m) { m.modes[0].damping = 1.0; }},
                        {"mode 1", [=](CutModel& m) { m.modes[0].damping = nan; }},
                        {"mode 1", [](CutModel& m) { m.modes[0].stiffness = -1.0; }},
                        {"mode 1", [=](CutModel& m) { m.modes[0].stiffness = infinite; }},
                        {"mode 2",
                         [](CutModel& m) {
                           m.modes[1].direction = {0.0, 0.0};
                         }},
                        {"mode 2",
                         [=](CutModel& m) {
                           m.modes[1].direction = {nan, 0.0};
                         }},
                        {"tool", [](CutModel& m) { m.tool.teeth = 0; }},
                        {"tool", [](CutModel& m) { m.tool.teeth = 201; }},
                        {"tool", [](CutModel& m) { m.tool.diameter = Metres(0.0); }},
                        {"tool", [=](CutModel& m) { m.tool.diameter = Metres(nan); }},
                        {"tool",
                         [](CutModel& m) {
                           m.tool.pitch = {1.0, 2.0};
                         }},
                        {"tool",
                         [](CutModel& m) {
                           m.tool.pitch = {2.0, 2.0, 2.0};
                         }},
                        {"tool",
                         [](CutModel& m) {
                           m.tool.pitch = {-1.0, 3.0, kTwoPi - 2.0};
                         }},
                        {"tool", [](CutModel& m) { m.tool.runout = {Metres(0.0)}; }},
                        {"tool",
                         [=](CutModel& m) {
                           m.tool.runout = {Metres(0.0), Metres(nan), Metres(0.0)};
                         }},
                        {"tool", [](CutModel& m) { m.tool.helix = 1.5; }},
                        {"tool", [=](CutModel& m) { m.tool.helix = nan; }},
                        {"material", [](CutModel& m) { m.material.tangential = 0.0; }},
                        {"material", [=](CutModel& m) { m.material.radial = nan; }},
                        {"material", [=](CutModel& m) { m.material.processDamping = infinite; }},
                        {"material", [](CutModel& m) { m.material.exponent = 0.0; }},
                        {"material", [](CutModel& m) { m.material.exponent = 1.01; }},
                        {"tool",
                         [](CutModel& m) {
                           m.tool.toothHelix = {0.1, 0.2};
                         }},
                        {"tool",
                         [=](CutModel& m) {
                           m.tool.toothHelix = {0.1, 0.2, nan};
                         }},
                        {"engagement", [](CutModel& m) { m.engagement.offset = 0.9; }},
                        {"engagement", [=](CutModel& m) { m.engagement.offset = nan; }},
                        {"engagement", [](CutModel& m) { m.engagement.radialImmersion = 0.0; }},
                        {"engagement", [](CutModel& m) { m.engagement.radialImmersion = 1.2; }},
                        {"engagement", [=](CutModel& m) { m.engagement.radialImmersion = nan; }}};
  for (const Case& c : cases) {
    CutModel model = sound();
    c.spoil(model);
    const Status status = check(model, "a.toml");
    ASSERT_FALSE(status.ok()) << c.place;
    const std::string line = status.error().line();
    EXPECT_EQ(line.rfind("a.toml", 0), 0u) << line;
    EXPECT_NE(line.find(c.place), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace stillcut::milling
