// What the person at the machine asks, as a value that enters the worker at a block boundary and is recorded with it.
#pragma once

#include <cstdint>
#include <string_view>

namespace stillcut {

enum class Authority : std::uint8_t { Off, Advise, Auto };
std::string_view name(Authority a);

enum class OperatorAction : std::uint8_t {
  SetAuthority,      // to `authority`
  Accept,            // the advice on screen, by its number: another one may have taken its place meanwhile
  Refuse,            // the advice on screen: not now
  BackToProgrammed,  // 100 %, and authority Off
  Hold,              // keep the present overrides
  EndHold,
  TrueAlarm,          // "that was chatter"
  FalseAlarm,         // "that was not chatter"
  ReportChatter,      // "I hear it now": chatter without an alarm
  GrantBySimulation,  // Auto, because the machine exists only in this program
  SetParameter,       // `parameter` to `value`, on the running cut; no authority is asked for
  UndoMark,           // the mark of the alarm of `value` was not meant; without one the newest mark of a moment
};

struct OperatorInput {
  OperatorAction action = OperatorAction::BackToProgrammed;
  Authority authority = Authority::Off;
  std::uint32_t advice = 0;  // Accept: the number of the advice that was on screen (Snapshot::adviceNumber)
  // SetParameter: config::parameterId() of the key, and its new value; not a number: automatic.
  std::uint32_t parameter = 0;
  double value = 0.0;  // also of an alarm's mark: when that alarm began [s of the stream]; 0: the newest
};

}  // namespace stillcut
