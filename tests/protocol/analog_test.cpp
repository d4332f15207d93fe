// Overrides as voltages: calibration tables, their files, and the link with a backend that only notes what it is told.
#include "core/cnc/analog/analog_link.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/cnc/analog/silent_output.h"
#include "core/cnc/link_trial.h"
#include "tests/protocol/commander.h"
#include "tests/protocol/commands.h"
#include "tests/support/virtual_clock.h"

namespace stillcut::cnc {
namespace {

using testing::CommandMaker;

struct Card {
  std::map<int, double> volts;
  std::vector<int> order;  // channels as they were written
  bool gone = false;
};

class NotingOutput final : public AnalogOutput {
 public:
  explicit NotingOutput(Card& card) : card_(card) {}
  Status open(const AnalogDevice& device) override {
    if (card_.gone) return Error{device.file, message("cannot be opened"), message("No such device")};
    return Done{};
  }
  bool write(int channel, double volts) noexcept override {
    if (card_.gone) return false;
    card_.volts[channel] = volts;
    card_.order.push_back(channel);
    return true;
  }

 private:
  Card& card_;
};

AnalogMap mapOf(const char* file) {
  auto map = loadAnalogMap(std::string(STILLCUT_SOURCE_DIR "/resources/machines/") + file);
  if (!map) throw std::runtime_error(map.error().line());
  return std::move(map).value();
}

AnalogLink linkOf(const char* file, Card& card, double rpm) {
  return {mapOf(file), std::make_unique<NotingOutput>(card), Rpm(rpm), fromMmPerMin(1000.0)};
}

TEST(CalibrationTable, GivesThePublishedVoltages) {
  const AnalogMap xu = mapOf("analog-xu-feed-and-speed.toml");
  EXPECT_NEAR(xu.feed->table.voltage(0.0), 1.3, 1e-12);
  EXPECT_NEAR(xu.feed->table.voltage(150.0), 4.8, 1e-12);
  EXPECT_NEAR(xu.feed->table.voltage(100.0), 1.3 + 3.5 * 100.0 / 150.0, 1e-12);
  EXPECT_NEAR(xu.speed->table.voltage(500.0), 1.0, 1e-12);
  EXPECT_NEAR(xu.speed->table.voltage(5000.0), 10.0, 1e-12);
}

TEST(CalibrationTable, NeverLeavesItsEndsAndGoesThroughEveryPoint) {
  const std::vector<CalibrationTable::Point> points{{0.5, 120.0}, {2.0, 100.0}, {2.5, 60.0}, {4.0, 50.0}};
  const auto table = CalibrationTable::make(points, "t");
  ASSERT_TRUE(table.ok());
  for (const auto& p : points) EXPECT_NEAR(table->voltage(p.value), p.volts, 1e-12);
  double last = table->voltage(40.0);
  for (double value = 40.0; value < 140.0; value += 0.37) {
    const double volts = table->voltage(value);
    EXPECT_GE(volts, 0.5);
    EXPECT_LE(volts, 4.0);
    EXPECT_LE(volts, last + 1e-12);  // this table falls
    last = volts;
  }
}

TEST(CalibrationTable, ReversedFlatShortAndEndlessTablesAreRefused) {
  using Points = std::vector<CalibrationTable::Point>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Points& bad : {Points{}, Points{{1.0, 100.0}}, Points{{1.0, 50.0}, {1.0, 100.0}},
                            Points{{2.0, 50.0}, {1.0, 100.0}}, Points{{1.0, 50.0}, {2.0, 50.0}},
                            Points{{1.0, 50.0}, {2.0, 100.0}, {3.0, 80.0}}, Points{{1.0, nan}, {2.0, 100.0}}}) {
    EXPECT_FALSE(CalibrationTable::make(bad, "t").ok());
  }
}

TEST(AnalogMap, BadFilesAreOneLine) {
  const std::string good = "version = 1\n[speed]\nchannel = 0\ntable = [[0.0, 50.0], [5.0, 120.0]]\n";
  ASSERT_TRUE(parseAnalogMap(good, "m").ok());
  struct Case {
    std::string from, to, says;
  };
  for (const Case& c : {Case{"[5.0, 120.0]", "[5.0, 90.0]", "100 %"}, Case{"[5.0, 120.0]", "[-1.0, 120.0]", "rise"},
                        Case{"[5.0, 120.0]", "[5.0, 120.0, 1.0]", "row of 3"}, Case{"[speed]", "[sped]", "missing"},
                        Case{"version = 1\n", "version = 1\n[feed]\nchannel = 0\ntable = [[0.0, 0.0], [5.0, 100.0]]\n",
                             "channel of"}}) {
    std::string text = good;
    text.replace(text.find(c.from), c.from.size(), c.to);
    const auto map = parseAnalogMap(text, "m");
    ASSERT_FALSE(map.ok()) << c.to;
    EXPECT_NE(map.error().line().find(c.says), std::string::npos) << map.error().line();
  }
}

TEST(Analog, HoldsTheProgrammedValuesFromOpenToTheEnd) {
  Card card;
  {
    AnalogLink link = linkOf("analog-hand-terminal.toml", card, 8000.0);
    ASSERT_TRUE(link.open().ok());
    EXPECT_NEAR(card.volts[0], 5.0 * 50.0 / 70.0, 1e-9);
    EXPECT_NEAR(card.volts[1], 5.0, 1e-9);
    CommandMaker gate;
    link.apply(gate.set(90.0), {});
    EXPECT_NEAR(card.volts[0], 5.0 * 40.0 / 70.0, 0.01);
    EXPECT_NEAR(card.volts[1], 4.5, 0.01);
    EXPECT_NEAR(link.read({}).speedOverride.value, 0.9, 0.001);
  }
  EXPECT_NEAR(card.volts[0], 5.0 * 50.0 / 70.0, 1e-9);
  EXPECT_NEAR(card.volts[1], 5.0, 1e-9);
}

// A card whose channels outlive the program that wrote them.
class LastingOutput final : public AnalogOutput {
 public:
  explicit LastingOutput(double* volts) : volts_(volts) {}
  Status open(const AnalogDevice& /*device*/) override { return Done{}; }
  bool write(int channel, double volts) noexcept override {
    volts_[channel] = volts;
    return true;
  }

 private:
  double* volts_;
};

TEST(Analog, KilledProgramLeavesItsVoltagesAndTheNextStartBringsTheProgrammedOnes) {
  constexpr std::size_t kSize = 2 * sizeof(double);
  void* const shared = ::mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(shared, MAP_FAILED);
  auto* const volts = static_cast<double*>(shared);
  const auto makeLink = [&] {
    return std::make_unique<AnalogLink>(mapOf("analog-hand-terminal.toml"), std::make_unique<LastingOutput>(volts),
                                        Rpm(8000.0), fromMmPerMin(1000.0));
  };
  const double programmed = 5.0 * 50.0 / 70.0;
  {
    const testing::Commander killed([&]() -> std::unique_ptr<CncLink> {
      auto link = makeLink();
      if (!link->open()) return nullptr;
      return link;
    });
    ASSERT_TRUE(killed.took());
  }  // killed
  EXPECT_NEAR(volts[0], 5.0 * 40.0 / 70.0, 0.01);
  EXPECT_NEAR(volts[1], 4.5, 0.01);
  {
    const auto link = makeLink();
    EXPECT_FALSE(link->describe().machineWatchdog);
    EXPECT_TRUE(link->open().ok());
    EXPECT_NEAR(volts[0], programmed, 1e-9);
    EXPECT_NEAR(volts[1], 5.0, 1e-9);
  }
  ::munmap(shared, kSize);
}

// No wire leads back: a machine that hangs, was restarted, lies, is in other hands or has no program any more looks as
// one that obeys. So nothing is claimed to have been read, and what it is left with is what stands on the outputs.
TEST(Analog, MachineTellsNothingSoNothingIsClaimedOfIt) {
  Card card;
  AnalogLink link = linkOf("analog-hand-terminal.toml", card, 8000.0);
  ASSERT_TRUE(link.open().ok());
  CommandMaker gate;
  link.apply(gate.set(90.0), instantFromNs(1'000'000));
  const MachineState m = link.read(instantFromNs(2'000'000));
  ASSERT_TRUE(m.valid);
  EXPECT_EQ(m.actualSpeed.value, 0.0);
  EXPECT_EQ(m.actualFeed.value, 0.0);
  for (const Instant read : {m.link.overrides, m.link.speed, m.link.feed, m.link.program}) EXPECT_EQ(read, Instant{});
  EXPECT_EQ(m.link.roundTrip.value, 0.0);
  link.release({});
  EXPECT_NEAR(card.volts[0], 5.0 * 50.0 / 70.0, 1e-9);  // for a restarted machine as well
  EXPECT_NEAR(card.volts[1], 5.0, 1e-9);
}

TEST(Analog, TrialLeavesTheOutputsAsTheyAre) {
  Card card;
  const test::VirtualClock clock;
  {
    AnalogLink link(mapOf("analog-hand-terminal.toml"),
                    std::make_unique<SilentOutput>(std::make_unique<NotingOutput>(card)), Rpm(8000.0),
                    fromMmPerMin(1000.0));
    LinkTrial trial(link, clock);
    while (trial.next()) {
    }
    EXPECT_TRUE(trial.passed());
  }
  EXPECT_TRUE(card.volts.empty());
  card.gone = true;
  AnalogLink absent(mapOf("analog-hand-terminal.toml"),
                    std::make_unique<SilentOutput>(std::make_unique<NotingOutput>(card)), Rpm(8000.0),
                    fromMmPerMin(1000.0));
  EXPECT_FALSE(absent.open().ok());
}

TEST(Analog, AbsoluteSpeedIsInRevolutions) {
  Card card;
  AnalogLink link = linkOf("analog-xu-feed-and-speed.toml", card, 3000.0);
  ASSERT_TRUE(link.open().ok());
  EXPECT_NEAR(card.volts[0], 1.0 + 9.0 * 2500.0 / 4500.0, 1e-9);
  EXPECT_NEAR(link.describe().highestSpeed.value, 5000.0 / 3000.0, 1e-9);
  EXPECT_FALSE(link.describe().machineWatchdog);
}

TEST(Analog, FeedFallsBeforeSpeedAndRisesAfterIt) {
  Card card;
  AnalogLink link = linkOf("analog-hand-terminal.toml", card, 8000.0);
  ASSERT_TRUE(link.open().ok());
  card.order.clear();
  CommandMaker gate;
  link.apply(gate.set(90.0), {});
  link.release({});
  EXPECT_EQ(card.order, (std::vector<int>{1, 0, 0, 1}));
}

TEST(Analog, SpeedOutsideTheGearsTableIsRefusedBeforeAnythingIsWritten) {
  Card card;
  AnalogLink link = linkOf("analog-xu-feed-and-speed.toml", card, 300.0);
  const Status opened = link.open();
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().line().find("outside the speed table"), std::string::npos);
  EXPECT_TRUE(card.volts.empty());
}

TEST(Analog, CardThatGoesIsAnInvalidMachine) {
  Card card;
  AnalogLink link = linkOf("analog-hand-terminal.toml", card, 8000.0);
  ASSERT_TRUE(link.open().ok());
  EXPECT_TRUE(link.read({}).valid);
  card.gone = true;
  CommandMaker gate;
  link.apply(gate.set(90.0), {});
  EXPECT_FALSE(link.read({}).valid);
  card.gone = false;
  link.release({});
  EXPECT_TRUE(link.read({}).valid);
  EXPECT_NEAR(card.volts[1], 5.0, 1e-9);
}

}  // namespace
}  // namespace stillcut::cnc
