// RecordingAnswer: what is said about a recording: chatter or not, how much of it that rests on, why the rest was not
// judged, and which speeds would be stable. Plain values: any thread. Made in core/evaluate, put into words in
// core/evaluate/answer_text.h.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/base/units.h"
#include "core/model/channel.h"
#include "core/model/reason.h"

namespace stillcut {

// What is not judged is neither stable nor free of alarms.
enum class Finding : std::uint8_t { NotJudged, NoChatter, Chatter };
// "not-judged", "no-chatter", "chatter"
std::string_view name(Finding f);

// How long something could not be judged for one reason; the reason names the channel where it is about one.
struct UnjudgedTime {
  Reason reason;
  Seconds time{};
};

struct ChannelAnswer {
  int index = 0;  // in the file, from 0
  std::string name;
  SensorQuantity quantity = SensorQuantity::Acceleration;
  std::vector<UnjudgedTime> faults;  // longest first; empty: in order all the time
};

// A column or track that is no vibration and was not judged.
struct LeftOutChannel {
  int index = 0;  // in the file, from 0
  std::string name;
  Message why;
};

// Why a speed is stable.
enum class SpeedBasis : std::uint8_t {
  WholeWaves,  // a whole number of chatter waves between two teeth: the centre of a pocket
  HalfWave,    // half a wave more: from there up the next pocket begins
  Lobes,       // between the stability limits of the known modes
};
// "whole-waves", "half-wave", "lobes"
std::string_view name(SpeedBasis b);

struct SpeedChoice {
  Rpm speed{};
  double waves = 0.0;  // of the chatter between two teeth, at that speed
  SpeedBasis basis = SpeedBasis::WholeWaves;
  Rpm from{}, to{};  // the stable range around it, of Lobes; else 0
};

struct SpeedAnswer {
  Hertz chatter{};
  int teeth = 0;                     // 0: not given
  Rpm present{};                     // in the signal, or nominal; 0: unknown
  double waves = 0.0;                // between two teeth at the present speed
  std::vector<SpeedChoice> choices;  // nearest first; empty: none, and `why` says why
  Metres depthLimit{};               // below it the present speed is stable, by the lobes; 0: not known
  Message why;                       // why there are no choices, or how far they can be relied on; may be empty
};

struct RecordingAnswer {
  std::string detector;  // whose answer it is
  Finding finding = Finding::NotJudged;
  Seconds length{};                     // missing samples included
  Seconds judged{};                     // in the steady cut, or in alarm
  Seconds air{};                        // air cutting: nothing to judge
  std::vector<UnjudgedTime> notJudged;  // the rest by reason, longest first
  Hertz hearsTo{};                      // chatter above this frequency is not found
  int alarms = 0;                       // times that onset or chatter began
  Seconds firstAlarm{};                 // with alarms
  Hertz chatter{};                      // dominant line of the alarms; 0: none
  double severity = 0.0;                // largest energy ratio in alarm
  std::vector<ChannelAnswer> channels;  // those that were judged
  std::vector<LeftOutChannel> leftOut;
  SpeedAnswer advice;  // with Finding::Chatter
};

}  // namespace stillcut
