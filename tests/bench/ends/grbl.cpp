// GRBL as tests/support/grbl/fake_grbl.h has it, behind TCP.
#include <optional>

#include "tests/bench/ends/kept.h"
#include "tests/bench/ends/machine.h"
#include "tests/bench/ends/scripted_grbl.h"
#include "tests/support/child.h"
#include "tests/support/grbl/tcp_grbl.h"

namespace stillcut::ends {
namespace {

using cnc::testing::FakeGrbl;

class Grbl final : public Machine {
 public:
  void delay(Seconds late) override { wire_.emplace(grbl_.port(), late); }
  std::unique_ptr<cnc::CncLink> link() override {
    return keptLink("grbl", {{"host", "127.0.0.1"}, {"port", std::to_string(wire_->port())}}, folder_.file(""));
  }
  Stand stands() override { return standsIn(grbl_); }
  void rest() override {
    pull(false);
    hang(false);
    lie(Lie::None);
    deaf(false);
    power(true);
    hand({100, 100});
  }
  bool hand(Stand percent) override {
    turn(grbl_, percent);
    return true;
  }
  bool pull(bool out) override {
    wire_->pull(out);
    return true;
  }
  bool hang(bool hangs) override {
    grbl_.hang(hangs);
    return true;
  }
  bool power(bool on) override {
    grbl_.with([&](FakeGrbl& g) { g.state = on ? "Run" : "Alarm"; });
    return true;
  }
  bool deaf(bool deaf) override {
    grbl_.with([&](FakeGrbl& g) { g.ignores = deaf; });
    return true;
  }
  // A bit of each "Ov:" is another: the line has no checksum.
  bool lie(Lie how) override {
    lieInReports(*wire_, how, "Ov:[0-9]+,100,[0-9]+", "Ov:93,100,93");
    return true;
  }

 private:
  cnc::testing::TemporaryFolder folder_;
  cnc::testing::TcpGrbl grbl_;
  std::optional<cnc::testing::DelayProxy> wire_;
};

}  // namespace

std::unique_ptr<Machine> makeGrbl() {
  return std::make_unique<Grbl>();
}

}  // namespace stillcut::ends
