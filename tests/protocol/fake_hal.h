// stillcut-hal beside the machine: the real keeper behind a scripted wire, a watchdog as LinuxCNC's component has it
// (armed by a rising edge, fallen until the next one), and halui, which follows a percentage within 120 ms of its
// change and only while it is enabled.
#pragma once

#include <optional>

#include "app/hal/override_arbiter.h"
#include "core/cnc/line_splitter.h"
#include "tests/protocol/fake_emc.h"

namespace stillcut::cnc::testing {

class FakeWatchdog {
 public:
  explicit FakeWatchdog(Duration patience = std::chrono::milliseconds(30)) : patience_(patience) {}
  bool ok = false, wired = true;
  void look(const hal::ArbiterPins& pins, Instant now) {
    if (pins.active && !armed_) ok = wired;
    armed_ = pins.active;
    if (pins.heartbeat != beat_ || (pins.active && !heard_)) heardAt_ = now;
    heard_ = pins.active;
    beat_ = pins.heartbeat;
    if (now - heardAt_ > patience_) ok = false;
  }

 private:
  Duration patience_;
  bool armed_ = false, beat_ = false, heard_ = false;
  Instant heardAt_{};
};

class FakeHal final : public Peer {
 public:
  FakeHal(FakeMill& mill, test::VirtualClock& clock) : mill_(mill), clock_(clock) {}

  static constexpr int kOurs = 1;  // number of the link under test
  bool killed = false;             // its pins stay as they were
  bool permit = true;
  int lost = 0;  // orders of halui that do not arrive
  FakeWatchdog watchdog;
  hal::OverrideArbiter keeper;
  hal::ArbiterPins pins;

  void gone() override {
    if (!killed) keeper.clientGone(kOurs, clock_.now());
  }
  void take(std::string_view bytes, Instant now, const Answer& answer) override {
    if (killed) return;
    splitter_.feed(bytes, [&](std::string_view line) {
      if (const auto request = readHalRequest(line)) keeper.take(*request, kOurs, now);
      std::array<char, kHalLine> text{};
      answer(std::string(writeHalReport(keeper.report(kOurs), text)), 0.0);
    });
  }
  // Every few milliseconds, as the machine's threads run.
  void tick() {
    const Instant now = clock_.now();
    if (!killed) pins = keeper.tick({watchdog.ok, permit}, now);
    watchdog.look(pins, now);
    mill_.adaptive = watchdog.ok ? pins.adaptiveFeed : 1.0;
    speed_.follow(watchdog.ok ? pins.speed : pins.restoreSpeed, pins.speedEnable, now, mill_.spindle,
                  mill_.shownSpindle, lost);
    feed_.follow(watchdog.ok ? pins.feed : pins.restoreFeed, pins.feedEnable, now, mill_.feed, mill_.shownFeed, lost);
  }

 private:
  struct Halui {
    int counts = 100;
    std::optional<Instant> due;
    void follow(int wanted, bool enabled, Instant now, int& inForce, int& shown, int& toLose) {
      if (wanted != counts) due = enabled ? std::optional(now + std::chrono::milliseconds(120)) : std::nullopt;
      counts = wanted;
      if (!due || now < *due) return;
      due.reset();
      if (toLose > 0) {
        --toLose;
      } else {
        inForce = shown = counts;
      }
    }
  };
  FakeMill& mill_;
  test::VirtualClock& clock_;
  LineSplitter splitter_;
  Halui speed_, feed_;
};

}  // namespace stillcut::cnc::testing
