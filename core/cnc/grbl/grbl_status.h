// What a GRBL 1.1 or grblHAL controller said: its status report and its parser state, taken apart. Fields that are not
// known are passed over (grblHAL adds its own), a field that makes no sense leaves its value as it was.
//   <Run|MPos:0,0,0|FS:1200,8800|Ov:110,100,100|A:S>     reply to '?'
//   [GC:G0 G54 G17 G21 G90 G94 M3 M9 T0 F1200 S8000]      reply to "$G"
// Thread: link thread. Real-time safe.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace stillcut::cnc {

enum class GrblState : std::uint8_t { Unknown, Idle, Run, Hold, Alarm, Other };

struct GrblReport {
  GrblState state = GrblState::Unknown;
  std::optional<double> feed;                      // units/min, as it moves now
  std::optional<double> speed;                     // rev/min, programmed times override: not measured
  std::optional<double> measuredSpeed;             // grblHAL with an encoder
  std::optional<int> feedOverride, speedOverride;  // %, only now and then
};

struct GrblWords {
  double feed = 0.0, speed = 0.0;
  bool inches = false;
};

enum class GrblLine : std::uint8_t { Report, Words, Welcome, AlarmNote, Other };

// What kind of line it is, with its content in `report` or `words`.
GrblLine readGrblLine(std::string_view line, GrblReport& report, GrblWords& words) noexcept;

// The real-time bytes that bring an override nearer to `target`: at most one coarse and one fine step, because the
// controller keeps one flag per kind and two equal bytes within one of its loops count once. 0: no byte.
struct GrblSteps {
  unsigned char coarse = 0, fine = 0;
  int percent = 100;                       // where the override stands after them
  int coarseAlone = 100, fineAlone = 100;  // where it stands if the other byte is lost
};
inline constexpr int kGrblLowest = 10, kGrblHighest = 200;
inline constexpr unsigned char kGrblFeedBytes = 0x90;     // 100 %, +10, -10, +1, -1
inline constexpr unsigned char kGrblSpindleBytes = 0x99;  // the same order
GrblSteps stepToward(int target, int present, unsigned char firstByte) noexcept;

}  // namespace stillcut::cnc
