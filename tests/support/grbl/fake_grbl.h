// A GRBL 1.1 controller behind a serial wire: real-time bytes without a reply, one flag per kind and loop, "Ov:" right
// after a change and otherwise in every tenth report. A report that is asked for in the same loop is written first.
// With `boot` it starts anew whenever its port is opened, as boards do whose USB chip pulls their reset.
#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "tests/support/scripted_wire.h"

namespace stillcut::cnc::testing {

class FakeGrbl final : public Peer {
 public:
  int feed = 100, spindle = 100;
  std::string state = "Run";
  double f = 1200.0, s = 8800.0;
  std::string extra;     // further fields, as grblHAL has them
  bool ignores = false;  // real-time bytes are lost on the way
  bool refusesSpeed = false, refusesFeed = false;
  int loses = 0;  // so many of the next real-time bytes
  int reports = 0;
  int lies = 0, liedFeed = 0;  // so many of the next "Ov:" say this feed
  std::string moved;           // 'f' or 's' for each step that was taken
  double boot = 0.0;           // [s] it is deaf after its port was opened
  int opened = 0;

  void connected() override {
    ++opened;
    starts_ = boot > 0.0;
  }
  // The operator's buttons: real-time bytes as well, so that the next report tells.
  void turn(int speed, int to) {
    spindle = speed;
    feed = to;
    changed_ = true;
  }
  void take(std::string_view bytes, Instant now, const Answer& answer) override {
    if (std::exchange(starts_, false)) {
      feed = spindle = 100;
      changed_ = true;
      ready_ = now + toDuration(Seconds(boot));
      answer("\r\nGrbl 1.1h ['$' for help]\r\n", boot);
    }
    if (now < ready_) return;
    // Everything of one write falls into one loop of the controller: equal bytes count once.
    if (bytes.find('?') != std::string_view::npos) report(now, answer);
    std::array<bool, 256> seen{};
    for (const char c : bytes) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte >= 0x90 && byte <= 0x9D && !ignores && !lost() && !std::exchange(seen[byte], true)) step(byte, now);
    }
    if (bytes.find("$G") != std::string_view::npos) {
      answer("[GC:G1 G54 G17 G21 G90 G94 M3 M9 T0 F" + std::to_string(f) + " S" + std::to_string(s) + "]\r\nok\r\n",
             0.005);
    }
  }

 private:
  bool lost() { return loses > 0 && loses-- > 0; }
  void step(unsigned char byte, Instant now) {
    static constexpr std::array<int, 5> kBy{0, 10, -10, 1, -1};
    const bool isFeed = byte < 0x95;
    if (byte >= 0x95 && byte < 0x99) return;  // rapids
    if (isFeed ? refusesFeed : refusesSpeed) return;
    const int by = kBy[static_cast<std::size_t>(byte - (isFeed ? 0x90 : 0x99)) % 5];
    moved += isFeed ? 'f' : 's';
    if (now != changedAt_) feedBefore_ = feed, spindleBefore_ = spindle;
    changedAt_ = now;
    int& value = isFeed ? feed : spindle;
    value = by == 0 ? 100 : std::clamp(value + by, 10, 200);
    changed_ = true;
  }
  void report(Instant now, const Answer& answer) {
    ++reports;
    const bool sameLoop = now == changedAt_;
    std::string r = "<" + state + "|MPos:1.000,2.000,0.000|FS:" + std::to_string(static_cast<int>(f * feed / 100)) +
                    "," + std::to_string(static_cast<int>(s * spindle / 100)) + extra;
    if ((changed_ && !sameLoop) || reports % 10 == 0) {
      const int said = lies > 0 && lies-- > 0 ? liedFeed : sameLoop ? feedBefore_ : feed;
      r += "|Ov:" + std::to_string(said) + ",100," + std::to_string(sameLoop ? spindleBefore_ : spindle) + "|A:S";
    }
    changed_ = changed_ && sameLoop;
    answer(r + ">\r\n", 0.005);
  }
  bool changed_ = false, starts_ = false;
  Instant ready_{};
  int feedBefore_ = 100, spindleBefore_ = 100;
  Instant changedAt_{};
};

}  // namespace stillcut::cnc::testing
