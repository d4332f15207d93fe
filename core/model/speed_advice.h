// SpeedAdvice: which spindle speed the present cut asks for, whoever may set it: the program, the operator by a touch,
// or somebody at the machine. It names one speed and one chatter frequency, and stands still while it is good. Plain
// value: any thread.
#pragma once

#include <cstdint>

#include "core/base/units.h"
#include "core/model/override_request.h"

namespace stillcut {

struct SpeedAdvice {
  enum class Kind : std::uint8_t {
    None,
    Speed,        // go to `speed`, in reach of the override
    OutOfReach,   // `speed` would do, and the override does not reach it: a matter for the program
    LessDepth,    // no speed will do
    ToProgrammed  // back to the programmed speed
  };
  Kind kind = Kind::None;
  Rpm speed{};
  MetresPerSecond feed{};  // that keeps the feed per tooth; 0: not known
  Rpm base{};              // the speed it is compared with: programmed, times the operator's override
  MetresPerSecond baseFeed{};
  Hertz chatter{};  // that it answers; 0: none
  Metres depth{};   // LessDepth: axial depth that is stable at `speed`; 0: not known
  Reason reason;
};

}  // namespace stillcut
