#include "core/model/reason.h"

#include <cstdio>
#include <string_view>

#include "core/model/operator_input.h"

namespace stillcut {
namespace {

// A pattern holds "{i.d}": number i with d decimals.
struct Row {
  ReasonCode code;
  std::string_view id;
  std::string_view pattern;
};

constexpr Row kRows[] = {
    {ReasonCode::None, "none", ""},
    {ReasonCode::Learning, "learning", "still learning, {0.1} s to go"},
    {ReasonCode::NoSpeed, "no-speed", "the spindle speed is not known"},
    {ReasonCode::NoTeeth, "no-teeth", "the number of flutes is not known"},
    {ReasonCode::NoAirCutting, "no-air",
     "a tone of {0.0} Hz fills the signal from its start, chatter or the machine itself"},
    {ReasonCode::InputGap, "input-gap", "samples are missing ({0.0} counted)"},
    {ReasonCode::InputClipped, "input-clipped", "the sensor is at its limit"},
    {ReasonCode::InputNotFinite, "input-not-finite", "channel {0.0} delivers values that are not numbers"},
    {ReasonCode::InputDead, "input-dead", "channel {0.0} delivers a constant"},
    {ReasonCode::InputSilent, "input-silent",
     "channel {0.0} fell silent in the middle of the cut, look for a broken cable"},
    {ReasonCode::InputLoose, "input-loose", "channel {0.0} knocks at any spindle angle, its sensor is loose"},
    {ReasonCode::InputOffset, "input-offset",
     "channel {0.0} has left its zero and stands at {1.1}, look at its supply and range"},
    {ReasonCode::InputHum, "input-hum",
     "most of what channel {0.0} delivers is mains hum of {1.0} Hz, look at its shield and ground"},
    {ReasonCode::InputNoise, "input-noise", "channel {0.0} delivers strong noise and no cut"},
    {ReasonCode::InputDoubled, "input-doubled",
     "channels {0.0} and {1.0} claim two axes and deliver the same, one of them is wired or named wrongly"},
    {ReasonCode::InputRepeated, "input-repeated",
     "channel {0.0} repeats its values, or comes at another rate than set"},
    {ReasonCode::InputRate, "input-rate", "the device delivers {0.1} samples a second instead of {1.1}"},
    {ReasonCode::InputAliased, "input-aliased",
     "channel {0.0} has a line at {1.1} Hz that moves as order {2.0} folded back, its anti-alias filter is missing"},
    {ReasonCode::SpindleRunUp, "spindle-runup", "the spindle is running up, {0.0} rpm"},
    {ReasonCode::Transient, "transient", "the tool is entering or leaving"},
    {ReasonCode::EnergyRatioHigh, "energy-ratio-high", "energy ratio {0.2} is over {1.2}"},
    {ReasonCode::EnergyRatioGrowing, "energy-ratio-growing", "energy ratio {0.3} grows above its floor of {1.3}"},
    {ReasonCode::LineOffHarmonics, "line-off-harmonics",
     "a line at {2.1} Hz between the harmonics holds {0.3} of the vibration, over {1.3}"},
    {ReasonCode::ResidualGrowing, "residual-growing",
     "vibration that the harmonics leave, {0.3} of all, is over {1.3}, strongest at {2.1} Hz"},
    {ReasonCode::CoherenceHigh, "coherence-high",
     "coherence ratio {0.2} is over {1.2} at {2.1} Hz and its energy grows"},
    {ReasonCode::NeedsTwoChannels, "needs-two-channels", "coherence needs two channels, there are {0.0}"},
    {ReasonCode::DetectorFault, "detector-fault", "detector {0.0} failed"},
    {ReasonCode::NothingToDo, "nothing-to-do", "nothing to do"},
    {ReasonCode::CentreOfNextPocket, "centre-of-next-pocket",
     "{0.0} rpm puts {1.0} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm"},
    {ReasonCode::FeedFollowsSpeed, "feed-follows-speed",
     "feed follows to {0.0} mm/min, so that each tooth still takes {1.3} mm"},
    {ReasonCode::TargetOutOfRange, "target-out-of-range",
     "{0.0} rpm would help against chatter of {3.0} Hz but the override reaches {1.0} to {2.0} rpm"},
    {ReasonCode::Monitoring, "monitoring", "monitoring only"},
    {ReasonCode::VerdictNotUsable, "verdict-not-usable", "there is no usable verdict to act on"},
    {ReasonCode::Recovering, "recovering", "going back towards {0.2}"},
    {ReasonCode::AlreadyThere, "already-there", "{0.0} rpm is already the speed for chatter at {1.0} Hz"},
    {ReasonCode::KeepingSpeed, "keeping-speed", "stable, keeping {0.0} rpm that chatter of {1.0} Hz asked for"},
    {ReasonCode::NextPocketInRange, "next-pocket-in-range",
     "{0.0} rpm with {1.0} waves between two teeth is in reach, {2.0} rpm is not (chatter {3.0} Hz)"},
    {ReasonCode::QuarterWave, "quarter-wave",
     "{0.0} rpm puts {1.2} chatter waves of {2.0} Hz between two teeth, from {3.0} rpm"},
    {ReasonCode::TowardLowerLevel, "toward-lower-level",
     "{0.0} rpm brings a tooth harmonic closer to the chatter, {1.1} Hz apart, level {2.2} of its mean"},
    {ReasonCode::SeekingMinimum, "seeking-minimum",
     "trying {0.0} rpm for less vibration, now {1.4}, best so far {2.4} at {3.0} rpm"},
    {ReasonCode::MinimumFound, "minimum-found", "{0.0} rpm vibrates least, {1.4}"},
    {ReasonCode::PocketByLobes, "pocket-by-lobes",
     "{0.0} rpm lies between the stability limits at {1.0} and {2.0} rpm (chatter {3.0} Hz)"},
    {ReasonCode::NoStableSpeed, "no-stable-speed",
     "no speed in reach is stable at this depth, {1.2} mm at {2.0} rpm would be (chatter {3.0} Hz)"},
    {ReasonCode::NoStableSpeedTried, "no-stable-speed-tried",
     "{0.0} speeds tried and none is stable (chatter {1.0} Hz): take less depth than where it began, {2.0} mm of feed "
     "before"},
    {ReasonCode::FuzzyRules, "fuzzy-rules",
     "coherence {0.2} and energy {1.1} times that of the stable cut ask for {2.0} rpm and {3.0} mm/min"},
    {ReasonCode::AuthorityOff, "authority-off", "authority is off"},
    {ReasonCode::AdviceOnly, "advice-only", "advice only"},
    {ReasonCode::GateNotFinite, "gate-not-finite", "the request was not a number"},
    {ReasonCode::GateLimited, "gate-limited", "asked for {0.0} %, the limits allow {1.0} %"},
    {ReasonCode::GateStaleMachine, "gate-stale-machine", "the machine's state is {0.2} s old"},
    {ReasonCode::GateStaleVerdict, "gate-stale-verdict", "the verdict is {0.2} s old"},
    {ReasonCode::GateMachineNotReady, "gate-machine-not-ready", "the machine is not running a program"},
    {ReasonCode::GateOperatorHold, "gate-operator-hold", "held by the operator"},
    {ReasonCode::GateSettling, "gate-settling", "waiting for the spindle, {0.0} of {1.0} rpm"},
    {ReasonCode::GateChangesPerMinute, "gate-changes-per-minute", "{0.0} changes in a minute, {1.0} allowed"},
    {ReasonCode::GateReleased, "gate-released", "the programmed values are back in force"},
    {ReasonCode::LeaseExpired, "lease-expired", "no fresh command for {0.2} s, programmed values restored"},
    {ReasonCode::GateInForce, "gate-in-force", "speed {0.1} % and feed {1.1} %, with the knobs {2.1} % and {3.1} %"},
    {ReasonCode::GateMoving, "gate-moving", "speed {0.1} % on its way to {1.1} %, feed {2.1} % to {3.1} %"},
    {ReasonCode::GateMachineInvalid, "gate-machine-invalid", "what the machine reports makes no sense"},
    {ReasonCode::GateMachineLocked, "gate-machine-locked",
     "the overrides have no effect: locked by the program, or at the machine's limit"},
    {ReasonCode::GateControlLost, "gate-control-lost", "something else controls the overrides"},
    {ReasonCode::GateVerdictInvalid, "gate-verdict-invalid", "the detector's verdict is not usable"},
    {ReasonCode::GateStaleRequest, "gate-stale-request", "the request is {0.2} s old"},
    {ReasonCode::GateClockFault, "gate-clock-fault", "time stood still, jumped or went back"},
    {ReasonCode::GateNotInCut, "gate-not-in-cut", "the tool is not in the cut"},
    {ReasonCode::GateFeedHold, "gate-feed-hold", "the feed is on hold"},
    {ReasonCode::GateOperatorOverrideMoved, "gate-knob-moved",
     "the operator turns the knobs: speed {0.0} %, feed {1.0} %"},
    {ReasonCode::GateNotFollowing, "gate-not-following", "the spindle does not follow, {0.0} instead of {1.0} rpm"},
    {ReasonCode::GateOverrideNotTaken, "gate-override-not-taken",
     "the machine does not take the override, {0.1} % instead of {1.1} %"},
    {ReasonCode::GateProgramChanged, "gate-program-changed",
     "the program went from {0.0} to {1.0} rpm, starting again from 100 %"},
    {ReasonCode::GateReengageDelay, "gate-resting", "waiting {0.1} s before taking the overrides again"},
    {ReasonCode::GateCoolDown, "gate-cool-down", "too many changes, waiting {0.0} s"},
    {ReasonCode::AutoNotAllowed, "auto-not-allowed", "Auto is not allowed in this set-up"},
    {ReasonCode::AutoWithdrawn, "auto-withdrawn", "more than {0.0} changes in a minute again, advice only from now on"},
    {ReasonCode::AdviceAccepted, "advice-accepted", "the operator accepted {0.0} rpm and {1.0} mm/min"},
    {ReasonCode::AdviceRefused, "advice-refused", "the operator refused {0.0} rpm and {1.0} mm/min"},
    {ReasonCode::ChatterBegan, "chatter-began", "chatter at {0.0} Hz, energy ratio {1.2}"},
    {ReasonCode::ChatterEnded, "chatter-ended", "stable again after {0.2} s and {1.1} mm of feed"},
    {ReasonCode::AuthorityChanged, "authority-changed", "authority changed from {0.0} to {1.0}"},
    {ReasonCode::BackToProgrammed, "back-to-programmed", "back to 100 % at the operator's request"},
    {ReasonCode::LinkLost, "link-lost", "the machine has not answered for {0.2} s"},
    {ReasonCode::LinkBack, "link-back", "the machine answers again"},
    {ReasonCode::RecorderStopped, "recorder-stopped", "recording has stopped"},
    {ReasonCode::DroppedBlocks, "dropped-blocks", "{0.0} blocks were dropped"},
    {ReasonCode::AutoGrantedBySimulation, "auto-granted-by-simulation",
     "Auto is granted because this machine is simulated"},
    {ReasonCode::StrategyFault, "strategy-fault", "the strategy failed, monitoring only from now on"},
    {ReasonCode::AdviceChanged, "advice-changed",
     "the advice has changed to {0.0} rpm and {1.0} mm/min, it needs another touch"},
    {ReasonCode::ChatterLeftCut, "chatter-left-cut",
     "the tool left the cut after {0.2} s and {1.1} mm of feed in chatter"},
    {ReasonCode::GateOverrideReset, "gate-override-reset",
     "the machine or its program put the override back to {0.0} %, Stillcut had it at {1.0} %"},
    {ReasonCode::EventsLost, "events-lost", "{0.0} lines more than there was room for, the most important were kept"},
    {ReasonCode::MonitoringAt, "monitoring-at", "monitoring only, at {0.0} rpm and an energy ratio of {1.2}"},
    {ReasonCode::NothingToDoAt, "nothing-to-do-at", "nothing to do at {0.0} rpm and an energy ratio of {1.2}"},
    {ReasonCode::NothingUsable, "nothing-usable", "verdict or machine state cannot be acted on, staying at {0.0} rpm"},
    {ReasonCode::TeethNotKnown, "teeth-not-known",
     "the number of flutes is not known, no speed follows from chatter of {0.0} Hz at {1.0} rpm"},
    {ReasonCode::InterventionNoHelp, "intervention-no-help",
     "the move to {0.0} rpm did not help ({1.0} in a row, {2.0} end Auto)"},
    {ReasonCode::InterventionLouder, "intervention-louder",
     "at {0.0} rpm the cut is {1.1} times as loud as before the move ({2.0} moves in a row without help, {3.0} end "
     "Auto)"},
    {ReasonCode::InterventionNotAgain, "intervention-not-again",
     "{0.0} rpm made the cut louder and is not tried again"},
    {ReasonCode::AutoWithoutHelp, "auto-without-help", "{0.0} moves in a row did not help, advice only from now on"},
    {ReasonCode::InterventionForced, "intervention-forced",
     "no chatter at {0.0} rpm, though the cut is {1.1} times as loud as before the move"},
    {ReasonCode::GateOldSamples, "gate-old-samples",
     "the newest samples that were judged are {0.2} s old, nothing is moved by them"},
    {ReasonCode::InputAbsurd, "input-absurd", "channel {0.0} delivers values that no sensor has"},
    {ReasonCode::MachineNeverRead, "machine-never-read", "nothing was read from a machine yet"},
    {ReasonCode::DriveTone, "drive-tone", "the tone of an axis drive glides, now at {0.0} Hz"},
};

const Row& rowOf(ReasonCode code) {
  for (const Row& r : kRows) {
    if (r.code == code) return r;
  }
  return kRows[0];
}

std::string numberText(const Reason& reason, std::size_t index, int decimals) {
  if (reason.code == ReasonCode::AuthorityChanged) {
    const double level = reason.n[index];  // from a damaged file it may be anything
    return std::string(name(level > 1.5 ? Authority::Auto : level > 0.5 ? Authority::Advise : Authority::Off));
  }
  char number[48];
  std::snprintf(number, sizeof number, "%.*f", decimals, reason.n[index]);
  return number;
}

}  // namespace

std::string_view identifier(ReasonCode code) {
  return rowOf(code).id;
}

std::string_view pattern(ReasonCode code) {
  return rowOf(code).pattern;
}

std::string sentence(const Reason& reason) {
  const std::string_view form = pattern(reason.code);
  std::string out;
  for (std::size_t i = 0; i < form.size(); ++i) {
    if (form[i] == '{' && i + 4 < form.size() && form[i + 2] == '.' && form[i + 4] == '}') {
      out += numberText(reason, static_cast<std::size_t>(form[i + 1] - '0'), form[i + 3] - '0');
      i += 4;
    } else {
      out += form[i];
    }
  }
  return out;
}

}  // namespace stillcut
