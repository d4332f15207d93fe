// Whole links on a wire where everything goes wrong at random: pieces, delays, replies that come together or out of
// order, noise, hangs, hang-ups, refused connections, a machine that is switched off, locked, taken over or aborted in
// the middle. Whatever came, no memory is heaped up, and once the wire is good again the machine is home. On virtual
// time, each storm from a seed.
#include <gtest/gtest.h>
#include <malloc.h>

#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/base/sanitized.h"
#include "core/cnc/grbl/grbl_link.h"
#include "core/cnc/linuxcnc/linuxcnc_link.h"
#include "core/cnc/modbus/modbus_link.h"
#include "tests/protocol/commands.h"
#include "tests/protocol/fake_emc.h"
#include "tests/protocol/fake_hal.h"
#include "tests/protocol/modbus/fake_plc.h"
#include "tests/support/grbl/fake_grbl.h"

namespace stillcut::cnc {
namespace {

using namespace testing;

#ifdef STILLCUT_SANITIZED_THREADS
constexpr int kSeeds = 8;  // each takes a hundred times as long, and a race wants no odds to show
#else
constexpr int kSeeds = 40;
#endif
constexpr double kTick = 0.005;
constexpr int kStorm = 12000;  // ticks: a minute

// A machine with its wires, and a link to it.
class World {
 public:
  explicit World(unsigned seed) : random_(seed) {}
  virtual ~World() = default;

  void storm() {
    const std::vector<OverrideCommand>& commands = orders();
    for (int tick = 0; tick < kStorm; ++tick) {
      if (oneIn(60)) bendTheWire();
      if (oneIn(400)) bendTheMachine();
      if (oneIn(300)) hangUp();
      if (oneIn(100)) babble();
      if (oneIn(50)) link_->apply(commands[below(commands.size())], clock_.now());
      if (oneIn(200)) link_->release(clock_.now());
      turn();
    }
  }
  void calm(double seconds) {
    mendTheWire();
    restore();
    for (const Instant end = clock_.now() + toDuration(Seconds(seconds)); clock_.now() < end;) turn();
  }
  void relinquish() { link_->release(clock_.now()); }
  void end() {
    const Instant began = clock_.now();
    link_.reset();
    EXPECT_LT(secondsBetween(began, clock_.now()).value, 1.6);
  }
  // What the machine is left with.
  virtual int speed() const = 0;
  virtual int feed() const = 0;
  const MachineState& seen() const { return seen_; }
  // How often the overrides in the machine changed.
  int moves() const { return moves_; }

 protected:
  virtual void bendTheWire() = 0;
  virtual void mendTheWire() = 0;
  virtual void hangUp() = 0;
  virtual void babble() = 0;
  virtual void restore() = 0;
  virtual void bendTheMachine() = 0;
  virtual void machine() {}

  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  bool oneIn(std::size_t n) { return below(n) == 0; }

  std::string noise() {
    std::string bytes(1 + below(300), '\0');
    for (char& c : bytes) c = static_cast<char>(below(256));
    if (oneIn(3)) bytes += "\r\n";
    return bytes;
  }

  test::VirtualClock clock_{instantFromNs(1'000'000'000)};
  std::unique_ptr<CncLink> link_;

 private:
  static const std::vector<OverrideCommand>& orders() {
    static const std::vector<OverrideCommand> all = [] {
      CommandMaker gate;
      std::vector<OverrideCommand> made;
      for (const double percent : {90.0, 95.0, 82.0, 100.0, 104.0}) made.push_back(gate.set(percent));
      made.push_back(gate.relinquish());
      return made;
    }();
    return all;
  }
  void turn() {
    const Instant before = clock_.now();
    seen_ = link_->read(before);
    EXPECT_LT(secondsBetween(before, clock_.now()).value, 0.1);  // a tick is short, whatever comes
    clock_.advance(Seconds(kTick));
    machine();
    if (speed() != lastSpeed_ || feed() != lastFeed_) ++moves_;
    lastSpeed_ = speed();
    lastFeed_ = feed();
  }

  std::mt19937 random_;
  MachineState seen_;
  int lastSpeed_ = 100, lastFeed_ = 100, moves_ = 0;
};

// On wires of bytes.
class WiredWorld : public World {
 public:
  using World::World;

 protected:
  std::unique_ptr<ScriptedWire> wire(Peer& peer) {
    auto made = std::make_unique<ScriptedWire>(clock_, faults_, peer);
    wires_.push_back(made.get());
    return made;
  }
  void hangUp() override { wires_[below(wires_.size())]->hangUp(); }
  void babble() override { wires_[below(wires_.size())]->say(noise()); }
  void mendTheWire() override { faults_ = {}; }
  void bendTheWire() override {
    switch (below(9)) {
      case 0:
        faults_.split(1 + below(5));
        break;
      case 1:
        faults_.merge(0.02 * static_cast<double>(below(5)));
        break;
      case 2:
        faults_.delay(0.001 * static_cast<double>(below(200)));
        break;
      case 3:
        faults_.wrongOrder(onePlace_ ? 0 : static_cast<int>(2 + below(20)));
        break;
      case 4:
        faults_.garbage(noise());
        break;
      case 5:
        faults_.hang(oneIn(2));
        break;
      case 6:
        faults_.refuse(oneIn(2));
        break;
      default:
        faults_ = {};
    }
  }

  bool onePlace_ = false;  // all that is said comes from one place in one order

 private:
  WireFaults faults_;
  std::vector<ScriptedWire*> wires_;
};

class LinuxCncWorld : public WiredWorld {
 public:
  LinuxCncWorld(unsigned seed, bool component, Dialect dialect = Dialect::Old)
      : WiredWorld(seed), component_(component) {
    mill_.dialect = dialect;
    onePlace_ = true;  // TCP: what one server says on one connection comes in order
    LinuxCncLink::Wires wires;
    wires.control = component ? wire(hal_) : wire(control_);
    wires.watch = wire(watch_);
    wires.hal = wire(halrmt_);
    LinuxCncSettings settings;
    if (component) settings.component.port = 5008;
    link_ = std::make_unique<LinuxCncLink>(settings, std::move(wires), clock_);
  }
  ~LinuxCncWorld() override { link_.reset(); }  // it still speaks to the peers below as it goes
  int speed() const override { return mill_.spindle; }
  int feed() const override { return mill_.feed; }

 protected:
  void machine() override {
    mill_.actual = mill_.commanded();
    if (!component_) return;
    for (int i = 0; i < 2; ++i) hal_.tick();
  }
  void bendTheMachine() override {
    switch (below(6)) {
      case 0:
        mill_.machineOn = mill_.running = oneIn(2);
        break;
      case 1:
        mill_.running = oneIn(2);
        break;
      case 2:
        mill_.lock(oneIn(2));
        break;
      case 3:
        mill_.owner = &other_;
        break;
      case 4:
        mill_.paused = oneIn(2);
        break;
      default:
        hal_.permit = oneIn(2);
    }
  }
  void restore() override {
    mill_.machineOn = mill_.running = hal_.permit = true;
    mill_.paused = false;
    mill_.lock(false);
  }

 private:
  bool component_;
  FakeMill mill_;
  FakeEmcClient control_{mill_}, watch_{mill_}, halrmt_{mill_}, other_{mill_};
  FakeHal hal_{mill_, clock_};
};

class GrblWorld : public WiredWorld {
 public:
  explicit GrblWorld(unsigned seed) : WiredWorld(seed) {
    onePlace_ = true;
    link_ = std::make_unique<GrblLink>(GrblSettings{}, wire(grbl_), clock_);
  }
  ~GrblWorld() override { link_.reset(); }
  int speed() const override { return grbl_.spindle; }
  int feed() const override { return grbl_.feed; }

 protected:
  void bendTheMachine() override {
    const char* const states[] = {"Run", "Hold:0", "Alarm", "Idle", "Door:1", "Run"};
    grbl_.state = states[below(6)];
    grbl_.loses = static_cast<int>(below(4));
    grbl_.extra = oneIn(2) ? "|Sl:3|H:1" : "";
  }
  void restore() override {
    grbl_.state = "Run";
    grbl_.loses = 0;
  }

 private:
  FakeGrbl grbl_;
};

// A bus of registers: what its driver makes of a bad wire is a late reply, or none. Nobody but the link brings it home.
class ModbusWorld : public World {
 public:
  explicit ModbusWorld(unsigned seed) : World(seed) {
    plc_.watched = false;
    plc_.holding(100) = plc_.holding(101) = 1000;
    link_ = std::make_unique<ModbusLink>(exampleMap(), std::make_unique<FakeBus>(clock_, plc_), clock_);
  }
  ~ModbusWorld() override { link_.reset(); }
  int speed() const override { return plc_.words.at({RegisterTable::Holding, 100}) / 10; }
  int feed() const override { return plc_.words.at({RegisterTable::Holding, 101}) / 10; }

 protected:
  void machine() override { plc_.run(clock_.now()); }
  void hangUp() override { plc_.cut = true; }
  void babble() override { plc_.garbled = static_cast<int>(below(4)); }
  void mendTheWire() override {
    plc_.silent = plc_.gone = plc_.refuses = false;
    plc_.garbled = 0;
    plc_.lostReply = -1;
    plc_.latency = std::chrono::milliseconds(1);
  }
  void bendTheWire() override {
    switch (below(8)) {
      case 0:
        plc_.latency = std::chrono::milliseconds(below(180));
        break;
      case 1:
        plc_.silent = oneIn(2);
        break;
      case 2:
        plc_.gone = oneIn(2);
        break;
      case 3:
        plc_.refuses = oneIn(2);
        break;
      case 4:
        plc_.lostReply = 100 + static_cast<int>(below(3));
        break;
      default:
        mendTheWire();
    }
  }
  void bendTheMachine() override {
    plc_.running = oneIn(2);
    plc_.operatorKnob = 80 + static_cast<int>(below(40));
  }
  void restore() override {
    plc_.running = true;
    plc_.operatorKnob = 100;
  }

 private:
  FakePlc plc_;
};

using Maker = std::function<std::unique_ptr<World>(unsigned seed)>;
struct Kind {
  const char* name;
  Maker make;
};
class LinkStorm : public ::testing::TestWithParam<Kind> {};

TEST_P(LinkStorm, EndsAtHomeOnceTheWireIsGoodAgain) {
  int moved = 0;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto world = GetParam().make(seed);
    world->storm();
    moved += world->moves() > 0 ? 1 : 0;
    world->relinquish();
    world->calm(25.0);  // another client keeps control for 10 s, a lost order is sent again after 6 s
    EXPECT_TRUE(world->seen().valid);
    EXPECT_EQ(world->speed(), 100);
    EXPECT_EQ(world->feed(), 100);
    world->end();
  }
  EXPECT_GT(moved, 3 * kSeeds / 4) << "orders got through, or nothing was put to the test";
}

// The end itself, in the middle of it: bounded, and on a good wire home.
TEST_P(LinkStorm, EndIsBoundedInTheMiddleOfIt) {
  for (unsigned seed = 101; seed <= 100 + kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto world = GetParam().make(seed);
    world->storm();
    world->end();
  }
}

TEST_P(LinkStorm, HeapsUpNoMemory) {
  const auto world = GetParam().make(7);
  world->storm();
  world->calm(1.0);
  const std::size_t before = ::mallinfo2().uordblks;
  for (int i = 0; i < 5; ++i) world->storm();
  world->calm(1.0);
  const std::size_t after = ::mallinfo2().uordblks;
  EXPECT_LT(after, before + 64 * 1024) << "after hundreds of kilobytes of noise";
}

INSTANTIATE_TEST_SUITE_P(
    Links, LinkStorm,
    ::testing::Values(Kind{"LinuxCncRsh", [](unsigned seed) { return std::make_unique<LinuxCncWorld>(seed, false); }},
                      Kind{"LinuxCncTen",
                           [](unsigned seed) { return std::make_unique<LinuxCncWorld>(seed, false, Dialect::Ten); }},
                      Kind{"LinuxCncMaster",
                           [](unsigned seed) { return std::make_unique<LinuxCncWorld>(seed, false, Dialect::Master); }},
                      Kind{"LinuxCncHal", [](unsigned seed) { return std::make_unique<LinuxCncWorld>(seed, true); }},
                      Kind{"Grbl", [](unsigned seed) { return std::make_unique<GrblWorld>(seed); }},
                      Kind{"Modbus", [](unsigned seed) { return std::make_unique<ModbusWorld>(seed); }}),
    [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace stillcut::cnc
