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
  NoAirCutting,        // Hz of a tone that fills the signal from its start
  InputGap,            // frames lost
  InputClipped,        // -
  InputNotFinite,      // channel
  InputDead,           // channel
  InputSilent,         // channel: fell silent in the cut
  InputLoose,          // channel
  InputOffset,         // channel, mean in SI
  InputHum,            // channel, mains Hz
  InputNoise,          // channel
  InputDoubled,        // channel, channel that delivers the same
  InputRepeated,       // channel
  InputRate,           // actual Hz, nominal Hz
  InputAliased,        // channel, line Hz, the order that it is
  SpindleRunUp,        // actual rpm
  Transient,           // seconds since the cut began or ended
  EnergyRatioHigh,     // ratio, limit
  EnergyRatioGrowing,  // ratio, floor
  LineOffHarmonics,    // its part of the vibration, limit, Hz
  ResidualGrowing,     // part of the vibration that the harmonics leave, floor, Hz
  CoherenceHigh,       // coherence ratio, limit, Hz
  NeedsTwoChannels,    // channels there are
  DetectorFault,       // detector index
  // requests
  NothingToDo,         // -
  CentreOfNextPocket,  // target rpm, pocket number p, chatter Hz, present rpm
  FeedFollowsSpeed,    // feed mm/min, feed per tooth mm
  TargetOutOfRange,    // wanted rpm, lowest rpm, highest rpm, chatter Hz
  Monitoring,          // -
  VerdictNotUsable,    // -
  Recovering,          // ratio towards
  AlreadyThere,        // rpm, chatter Hz: the speed is the one that the rule asks for
  KeepingSpeed,        // rpm kept since chatter cleared, Hz of that chatter
  NextPocketInRange,   // target rpm, pocket number p, rpm out of reach, chatter Hz
  QuarterWave,         // target rpm, waves n + nu, chatter Hz, present rpm
  TowardLowerLevel,    // target rpm, chatter Hz minus the harmonic, level over its mean
  SeekingMinimum,      // target rpm, level there, lowest level so far, its rpm
  MinimumFound,        // target rpm, level
  PocketByLobes,       // target rpm, lowest and highest stable rpm around it, chatter Hz
  NoStableSpeed,       // depth mm of the cut, depth mm that would do, its rpm, chatter Hz
  NoStableSpeedTried,  // speeds tried, chatter Hz, mm of feed since it began
  FuzzyRules,          // coherence, energy over that of the stable cut (0: not known), target rpm, feed mm/min
  // gate
  AuthorityOff,               // -
  AdviceOnly,                 // -
  GateNotFinite,              // -
  GateLimited,                // wanted %, given %
  GateStaleMachine,           // age s
  GateStaleVerdict,           // age s
  GateMachineNotReady,        // -
  GateOperatorHold,           // -
  GateSettling,               // actual rpm, commanded rpm
  GateChangesPerMinute,       // changes, allowed
  GateReleased,               // -
  LeaseExpired,               // age s
  GateInForce,                // our speed %, our feed %, product speed %, product feed %
  GateMoving,                 // our speed % now, wanted %, our feed % now, wanted %
  GateMachineInvalid,         // -: the machine's state makes no sense
  GateMachineLocked,          // -: overrides disabled by the program
  GateControlLost,            // -: another client has them
  GateVerdictInvalid,         // -
  GateStaleRequest,           // age s
  GateClockFault,             // -: stream time stood still or went back
  GateNotInCut,               // -
  GateFeedHold,               // -
  GateOperatorOverrideMoved,  // operator's speed %, feed %
  GateNotFollowing,           // read back rpm, expected rpm
  GateOverrideNotTaken,       // override read back %, expected %
  GateProgramChanged,         // programmed rpm before, now
  GateReengageDelay,          // seconds until the overrides may be taken again
  GateCoolDown,               // seconds left
  AutoNotAllowed,             // -
  AutoWithdrawn,              // changes per minute allowed: authority falls back to Advise
  AdviceAccepted,             // rpm, feed mm/min
  AdviceRefused,              // rpm, feed mm/min
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
  StrategyFault,            // -: monitoring from now on
  AdviceChanged,            // rpm, feed mm/min: what was accepted is no longer what is advised
  ChatterLeftCut,           // seconds in chatter, mm of feed: the tool left the cut before it was quiet
  GateOverrideReset,        // override read back %, ours until then %: somebody else's doing, not a lock
  EventsLost,               // events of earlier steps that found no room
  // requests again: sessions store a code as its place here, so that new ones come last
  MonitoringAt,        // rpm, energy ratio
  NothingToDoAt,       // rpm, energy ratio
  NothingUsable,       // rpm stayed at: verdict or machine state cannot be acted on
  TeethNotKnown,       // chatter Hz (0: none), rpm: no other speed follows from them
  InterventionNoHelp,  // rpm moved to, moves in a row without help, how many of them end Auto
  InterventionLouder,  // rpm moved to, times as loud as before, moves in a row without help, how many of them end Auto
  InterventionNotAgain,  // rpm that was louder, and is asked for again
  AutoWithoutHelp,       // moves in a row without help: authority falls back to Advise
  InterventionForced,    // rpm moved to, times as loud as before: quiet of chatter, but loud
  GateOldSamples,        // age s of the newest samples that were judged, by the machine's newest state
  InputAbsurd,           // channel
  MachineNeverRead,      // -: there is no machine, or it has not answered yet
  DriveTone,             // Hz of an axis drive's tone, which glides
};

struct Reason {
  ReasonCode code = ReasonCode::None;
  std::array<double, 4> n{};
};

// The stable identifier of a code ("input-gap"), for files and tests. Not real-time.
std::string_view identifier(ReasonCode code);
// The sentence with "{i.d}" where number i belongs with d decimals: what screens translate. Not real-time.
std::string_view pattern(ReasonCode code);
// One English sentence with its numbers, without a full stop. Not real-time.
std::string sentence(const Reason& reason);

}  // namespace stillcut
