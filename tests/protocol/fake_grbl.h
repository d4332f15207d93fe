// A GRBL 1.1 controller behind a serial wire: real-time bytes without a reply, one flag per kind and loop, "Ov:" right
// after a change and otherwise in every tenth report.
#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "tests/protocol/scripted_wire.h"

namespace stillcut::cnc::testing {

class FakeGrbl final : public Peer {
 public:
  int feed = 100, spindle = 100;
  std::string state = "Run";
  double f = 1200.0, s = 8800.0;
  std::string extra;     // further fields, as grblHAL has them
  bool ignores = false;  // real-time bytes are lost on the way
  int reports = 0;
  std::string moved;  // 'f' or 's' for each step that was taken

  void take(std::string_view bytes, Instant, const Answer& answer) override {
    // Everything of one write falls into one loop of the controller: equal bytes count once.
    std::array<bool, 256> seen{};
    for (const char c : bytes) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte >= 0x90 && byte <= 0x9D && !ignores && !std::exchange(seen[byte], true)) step(byte);
    }
    if (bytes.find('?') != std::string_view::npos) report(answer);
    if (bytes.find("$G") != std::string_view::npos) {
      answer("[GC:G1 G54 G17 G21 G90 G94 M3 M9 T0 F" + std::to_string(f) + " S" + std::to_string(s) + "]\r\nok\r\n",
             0.005);
    }
  }

 private:
  void step(unsigned char byte) {
    static constexpr std::array<int, 5> kBy{0, 10, -10, 1, -1};
    const bool isFeed = byte < 0x95;
    if (byte >= 0x95 && byte < 0x99) return;  // rapids
    const int by = kBy[static_cast<std::size_t>(byte - (isFeed ? 0x90 : 0x99)) % 5];
    moved += isFeed ? 'f' : 's';
    int& value = isFeed ? feed : spindle;
    value = by == 0 ? 100 : std::clamp(value + by, 10, 200);
    changed_ = true;
  }
  void report(const Answer& answer) {
    ++reports;
    std::string r = "<" + state + "|MPos:1.000,2.000,0.000|FS:" + std::to_string(static_cast<int>(f * feed / 100)) +
                    "," + std::to_string(static_cast<int>(s * spindle / 100)) + extra;
    if (changed_ || reports % 10 == 0) {
      r += "|Ov:" + std::to_string(feed) + ",100," + std::to_string(spindle) + "|A:S";
    }
    changed_ = false;
    answer(r + ">\r\n", 0.005);
  }
  bool changed_ = false;
};

}  // namespace stillcut::cnc::testing
