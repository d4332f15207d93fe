// Reason: why, as a code and numbers. The sample path fills it without formatting text; sentence() makes the English
// sentence later, on the thread of whoever shows or stores it. The screens translate by code.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace stillcut {

// Each code says which numbers it carries, in order.
enum class ReasonCode : std::uint16_t {
  None,
  // verdicts
  Learning,            // seconds still needed
  NoSpeed,             // -
  NoTeeth,             // -
  InputGap,            // frames lost
  InputClipped,        // -
  InputNotFinite,      // channel
  InputDead,           // channel
  SpindleRunUp,        // actual rpm
  Transient,           // seconds since the cut began or ended
  EnergyRatioHigh,     // ratio, limit
  EnergyRatioGrowing,  // ratio, floor
  DetectorFault,       // detector index
  // requests
  NothingToDo,         // -
  CentreOfNextPocket,  // target rpm, pocket number p, chatter Hz, present rpm
  FeedFollowsSpeed,    // feed mm/min, feed per tooth mm
  TargetOutOfRange,    // wanted rpm, lowest rpm, highest rpm
  Monitoring,          // -
  VerdictNotUsable,    // -
  Recovering,          // ratio towards
  // gate
  AuthorityOff,          // -
  AdviceOnly,            // -
  GateNotFinite,         // -
  GateLimited,           // wanted ratio, given ratio
  GateStaleMachine,      // age s
  GateStaleVerdict,      // age s
  GateMachineNotReady,   // -
  GateOperatorHold,      // -
  GateSettling,          // actual rpm, commanded rpm
  GateChangesPerMinute,  // changes, allowed
  GateReleased,          // -
  LeaseExpired,          // age s
  // events
  ChatterBegan,             // Hz, energy ratio
  ChatterEnded,             // seconds in chatter, mm of feed
  AuthorityChanged,         // from, to
  BackToProgrammed,         // -
  LinkLost,                 // age s
  LinkBack,                 // -
  RecorderStopped,          // -
  DroppedBlocks,            // blocks
  AutoGrantedBySimulation,  // -
};

struct Reason {
  ReasonCode code = ReasonCode::None;
  std::array<double, 4> n{};
};

// The stable identifier of a code ("input-gap"), for files and tests. Not real-time.
std::string_view identifier(ReasonCode code);
// One English sentence with its numbers, without a full stop. Not real-time.
std::string sentence(const Reason& reason);

}  // namespace stillcut
